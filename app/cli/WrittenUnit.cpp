#include "app/cli/WrittenUnit.h"

#include "core/base/Numbers.h"
#include "core/io/IntoMetres.h"

namespace vestige::cli {

void putIntoUnitOf(const FileFormat& target, const std::string& out, const std::string& in,
                   const ReadUnit& unit, LoadedGeometry& loaded, const Session& session) {
    // Also where the user has metres in a file that names another unit: what it says would go along.
    const bool asItSays = loaded.info.metresPerUnit.value_or(1) == unit.metresPerUnit;
    if (!target.writesMetres() || (unit.metresPerUnit == 1 && asItSays)) return;
    moveIntoMetres(loaded, {Pose::Identity(), unit.metresPerUnit});
    if (unit.metresPerUnit != 1)
        session.log(in + " has " + exactText(unit.metresPerUnit) + " m a unit, as " +
                    (unit.given ? "--unit" : "it") + " says; " + out + " holds metres");
}

}  // namespace vestige::cli
