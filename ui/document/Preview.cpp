#include "ui/document/Preview.h"

// The meta-object code of Preview is compiled with this file.
