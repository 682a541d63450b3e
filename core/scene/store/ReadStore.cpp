#include <cstdlib>

#include "core/base/CleanText.h"
#include "core/base/Hash.h"
#include "core/scene/store/CaseStore.h"
#include "core/scene/store/Database.h"
#include "core/scene/store/Schema.h"

namespace vestige {
namespace {

namespace fs = std::filesystem;

std::string textOf(const Database::Value& value) {
    const auto* text = std::get_if<std::string>(&value);
    return text ? *text : std::string();
}

StoredCase contentOf(Database& database) {
    StoredCase stored;
    if (!hasSchema(database)) return stored;
    // One picture of it, whatever a window commits meanwhile.
    database.run("BEGIN");
    const std::int64_t base = lastSave(database);
    const auto saved = database.value("SELECT case_text FROM saves WHERE id=?", {base});
    if (const auto* text = std::get_if<std::string>(&saved)) stored.saved = *text;
    for (const auto& row : database.run(
             "SELECT case_text FROM journal WHERE base=? AND case_text IS NOT NULL ORDER BY id DESC LIMIT 10",
             {base}))
        stored.drafts.push_back(textOf(row.front()));
    if (!stored.drafts.empty() && stored.saved && stored.drafts.front() == *stored.saved)
        stored.drafts.clear();
    if (!stored.drafts.empty()) {
        stored.unsaved = database.number("SELECT count(*) FROM journal WHERE base=?", {base});
        const auto last = database.run(
            "SELECT edit, time, moment FROM journal WHERE base=? ORDER BY id DESC LIMIT 1", {base});
        if (!last.empty()) {
            stored.lastEdit = cleanText(textOf(last.front()[0]), 200);
            stored.lastTime = cleanText(textOf(last.front()[1]));
            const auto* moment = std::get_if<std::int64_t>(&last.front()[2]);
            stored.lastMoment = moment ? *moment : 0;
        }
    }
    stored.caseFile = textOf(database.value("SELECT value FROM facts WHERE key='case'"));
    database.run("COMMIT");
    return stored;
}

bool copyIsOurs(Database& database, const fs::path& json) {
    std::error_code unknown;
    if (!fs::is_regular_file(json, unknown)) return !fs::exists(fs::symlink_status(json, unknown));
    const auto hash = sha256OfFile(json);
    return !hash || database.number("SELECT count(*) FROM saves WHERE sha256=?", {*hash}) > 0;
}

Result<StoredCase> readWith(const fs::path& folder, Database::Access access) {
    const fs::path file = folder / "case.db";
    return guarded(file.string(), [&]() -> Result<StoredCase> {
        Database database(file, access);
        StoredCase stored = contentOf(database);
        if (stored.saved) stored.copyChanged = !copyIsOurs(database, folder / "case.json");
        return stored;
    });
}

/// Where a killed window left a half-written change that only a writer may take back, on a medium that cannot
/// be written: a copy is read.
Result<StoredCase> readCopy(const fs::path& folder) {
    std::error_code error;
    if (!fs::is_regular_file(fs::symlink_status(folder / "case.db", error)))
        return fail(ErrorCode::input, "a case's database is expected here, as a file", folder.string());
    std::string place = (fs::temp_directory_path(error) / "vestige-case-XXXXXX").string();
    if (!::mkdtemp(place.data()))
        return fail(ErrorCode::output, "no folder can be made for a copy of the case", place);
    const fs::path copy = place;
    for (const char* name : {"case.db", "case.db-journal", "case.db-wal", "case.json"}) {
        std::error_code missing;
        if (fs::is_regular_file(fs::symlink_status(folder / name, missing)))
            fs::copy_file(folder / name, copy / name, fs::copy_options::overwrite_existing, missing);
    }
    fs::permissions(copy / "case.db", fs::perms::owner_write, fs::perm_options::add, error);
    auto stored = readWith(copy, Database::Access::write);
    fs::remove_all(copy, error);
    return stored;
}

}  // namespace

std::string StoredCase::unsavedSentence() const {
    return (unsaved == 1 ? std::string("1 change was not saved")
                         : std::to_string(unsaved) + " changes were not saved") +
           " (the last: " + lastEdit + ", " + lastTime + ")";
}

Result<StoredCase> readCaseStore(const fs::path& folder) {
    std::error_code unknown;
    if (!fs::exists(fs::symlink_status(folder / "case.db", unknown))) return StoredCase();
    auto stored = readWith(folder, Database::Access::read);
    if (stored) return stored;
    const Error first = stored.error();
    // A change that a killed window left half-written is taken back by whoever may write.
    stored = readWith(folder, Database::Access::write);
    if (!stored) stored = readCopy(folder);
    if (stored) return stored;
    return fail(first);
}

}  // namespace vestige
