#include "ui/document/Notices.h"

// The meta-object code of Notices is compiled with this file.
