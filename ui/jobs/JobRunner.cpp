#include "ui/jobs/JobRunner.h"

// The meta-object code of JobRunner is compiled with this file.
