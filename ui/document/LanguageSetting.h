#pragma once

#include "core/base/Language.h"

namespace vestige {

/// What the user chose last; at first that of the system's locale where it is one of ours, else English.
Language storedLanguage();
void storeLanguage(Language language);

/// The name of a language in itself: "English", "简体中文".
const char* nativeName(Language language);

/// With this code the application's event loop ends when its window is to open again in another language.
constexpr int kOpenAgain = 1000;

}  // namespace vestige
