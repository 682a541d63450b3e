#pragma once

#include "core/base/Language.h"

namespace vestige {

/// Has core, the window and Qt's own dialogs speak it: texts that are made from now on. Needs the
/// application; before the first window.
void useLanguage(Language language);

}  // namespace vestige
