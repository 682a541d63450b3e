#pragma once

#include "core/scene/store/Database.h"

namespace vestige {

/// Makes the tables of a new database; throws for one that is not Vestige's or of a later version. One
/// without any table is new.
void prepareSchema(Database& database);
/// False for a new one; throws as above.
bool hasSchema(Database& database);

/// The row of `saves` that is the saved case; 0: none.
std::int64_t lastSave(Database& database);

}  // namespace vestige
