#pragma once

#include "core/pipeline/ViewRenderer.h"

namespace vestige {

/// Style, font, palette and style sheet of the application in that theme. Cheap when it has it already.
void applyTheme(Theme theme);

/// What the user chose last; dark at first.
Theme storedTheme();
void storeTheme(Theme theme);

}  // namespace vestige
