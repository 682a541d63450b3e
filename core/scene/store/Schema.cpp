#include "core/scene/store/Schema.h"

#include "core/base/Result.h"

namespace vestige {
namespace {

constexpr std::int64_t kApplication = 0x56535447;  // "VSTG"
constexpr std::int64_t kSchemaVersion = 1;

}  // namespace

bool hasSchema(Database& database) {
    if (database.number("SELECT count(*) FROM sqlite_schema") == 0) return false;
    if (database.number("PRAGMA application_id") != kApplication)
        throw ErrorException{
            {ErrorCode::input, "this database is no case of Vestige", database.file().string(), {}}};
    if (database.number("PRAGMA user_version") > kSchemaVersion)
        throw ErrorException{{ErrorCode::input, "the case was written by a later version of Vestige",
                              database.file().string(),
                              "expected: a case of this version or an earlier one"}};
    return true;
}

void prepareSchema(Database& database) {
    if (hasSchema(database)) return;
    Database::Transaction change(database);
    // case_text is null for states that later ones have replaced.
    database.run(
        "CREATE TABLE saves(id INTEGER PRIMARY KEY AUTOINCREMENT, time TEXT NOT NULL, program TEXT NOT NULL, "
        "case_text TEXT, sha256 TEXT NOT NULL)");
    // moment: nanoseconds since 1970, to order the journals of two places. base: the row of `saves` that the
    // edits change; 0 where nothing was saved.
    database.run(
        "CREATE TABLE journal(id INTEGER PRIMARY KEY AUTOINCREMENT, time TEXT NOT NULL, moment INTEGER NOT "
        "NULL, base INTEGER NOT "
        "NULL, "
        "edit TEXT NOT NULL, case_text TEXT)");
    database.run("CREATE INDEX journal_base ON journal(base)");
    database.run("CREATE TABLE facts(key TEXT PRIMARY KEY, value TEXT NOT NULL)");
    database.run("PRAGMA application_id=1448301639");  // kApplication
    database.run("PRAGMA user_version=1");
    change.commit();
}

std::int64_t lastSave(Database& database) {
    return database.number("SELECT max(id) FROM saves WHERE case_text IS NOT NULL");
}

}  // namespace vestige
