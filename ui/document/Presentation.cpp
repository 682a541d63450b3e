#include "ui/document/Presentation.h"

// The meta-object code of Presentation is compiled with this file.
