#include "ui/document/Selection.h"

// The meta-object code of Selection is compiled with this file.
