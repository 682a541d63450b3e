#include "core/scene/store/Database.h"

#include <sqlite3.h>

#include <cstring>
#include <initializer_list>

#include "core/base/Result.h"
#include "core/scene/casefile/CaseText.h"
#include "core/scene/store/SideFiles.h"

namespace vestige {
namespace {

/// In steps of SQLite's machine; an honest case takes thousands.
constexpr int kStepsPerLook = 10000;
constexpr int kMostLooks = 20000;
/// How long to wait for another process that commits.
constexpr int kPatience_ms = 3000;

std::string sentenceOf(int code, int systemError) {
    const std::string system = systemError != 0 ? std::string(": ") + std::strerror(systemError) : "";
    switch (code & 0xff) {
        case SQLITE_FULL:
            return "the disk is full";
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            return "another program is writing to the case";
        case SQLITE_READONLY:
            return code == SQLITE_READONLY_DBMOVED ? "the case's folder was moved or deleted"
                                                   : "the case cannot be written: it is read-only";
        case SQLITE_PERM:
        case SQLITE_CANTOPEN:
            return "the case's database cannot be opened" + system;
        case SQLITE_IOERR:
            return "the disk refused" + system;
        case SQLITE_CORRUPT:
        case SQLITE_NOTADB:
        case SQLITE_INTERRUPT:
        case SQLITE_TOOBIG:
            return "this is no case database, or it is damaged";
        case SQLITE_NOMEM:
            return "there is not enough memory";
        default:
            return std::string("the case's database answers: ") + sqlite3_errstr(code);
    }
}

}  // namespace

struct Database::Connection {
    std::filesystem::path file;
    Access access;
    sqlite3* handle = nullptr;
    int looks = 0;

    ~Connection() { sqlite3_close(handle); }

    [[noreturn]] void refuse(int code) const {
        const bool damaged = (code & 0xff) == SQLITE_CORRUPT || (code & 0xff) == SQLITE_NOTADB;
        throw ErrorException{
            {access == Access::read || damaged ? ErrorCode::input : ErrorCode::output,
             sentenceOf(code, handle ? sqlite3_system_errno(handle) : 0), file.string(),
             damaged ? "case.json beside it is the readable copy of the last saved case" : ""}};
    }
    void check(int code) const {
        if (code != SQLITE_OK) refuse(handle ? sqlite3_extended_errcode(handle) : code);
    }
};

Database::Database(const std::filesystem::path& file, Access access)
    : connection_(std::make_unique<Connection>()) {
    Connection& db = *connection_;
    db.file = file;
    db.access = access;
    // A pipe would be waited for, and a link would lead out of the case.
    std::error_code unknown;
    const auto type = std::filesystem::symlink_status(file, unknown).type();
    if (type != std::filesystem::file_type::regular &&
        (access == Access::read || type != std::filesystem::file_type::not_found))
        throw ErrorException{{access == Access::read ? ErrorCode::input : ErrorCode::output,
                              "a case's database is expected here, as a file",
                              file.string(),
                              {}}};
    checkSideFiles(file);
    const int flags =
        access == Access::read ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
    db.check(sqlite3_open_v2(file.c_str(), &db.handle, flags | SQLITE_OPEN_FULLMUTEX | SQLITE_OPEN_EXRESCODE,
                             nullptr));
    for (const auto& [option, on] :
         std::initializer_list<std::pair<int, int>>{{SQLITE_DBCONFIG_DEFENSIVE, 1},
                                                    {SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0},
                                                    {SQLITE_DBCONFIG_ENABLE_TRIGGER, 0},
                                                    {SQLITE_DBCONFIG_ENABLE_VIEW, 0}})
        sqlite3_db_config(db.handle, option, on, nullptr);
    sqlite3_limit(db.handle, SQLITE_LIMIT_ATTACHED, 0);
    sqlite3_limit(db.handle, SQLITE_LIMIT_LENGTH, static_cast<int>(kLargestCaseText) + (1 << 20));
    sqlite3_busy_timeout(db.handle, kPatience_ms);
    sqlite3_progress_handler(
        db.handle, kStepsPerLook,
        [](void* looks) { return ++*static_cast<int*>(looks) > kMostLooks ? 1 : 0; }, &db.looks);
    run("PRAGMA cell_size_check=ON");
    if (access == Access::read) return;
    run("PRAGMA journal_mode=DELETE");
    run("PRAGMA synchronous=EXTRA");
}

Database::~Database() = default;

std::vector<Database::Row> Database::run(const char* statement, const std::vector<Value>& values) {
    Connection& db = *connection_;
    db.looks = 0;
    sqlite3_stmt* prepared = nullptr;
    db.check(sqlite3_prepare_v2(db.handle, statement, -1, &prepared, nullptr));
    const std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)> owner(prepared, sqlite3_finalize);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const int place = static_cast<int>(i) + 1;
        if (const auto* number = std::get_if<std::int64_t>(&values[i]))
            db.check(sqlite3_bind_int64(prepared, place, *number));
        else if (const auto* text = std::get_if<std::string>(&values[i]))
            db.check(
                sqlite3_bind_text64(prepared, place, text->data(), text->size(), SQLITE_STATIC, SQLITE_UTF8));
    }
    std::vector<Row> rows;
    int code = SQLITE_ROW;
    while ((code = sqlite3_step(prepared)) == SQLITE_ROW) {
        Row row;
        for (int i = 0; i < sqlite3_column_count(prepared); ++i) {
            const int type = sqlite3_column_type(prepared, i);
            if (type == SQLITE_INTEGER)
                row.emplace_back(std::int64_t{sqlite3_column_int64(prepared, i)});
            else if (type == SQLITE_TEXT) {
                const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(prepared, i));
                if (!text) db.refuse(SQLITE_NOMEM);
                row.emplace_back(
                    std::string(text, static_cast<std::size_t>(sqlite3_column_bytes(prepared, i))));
            } else
                row.emplace_back();
        }
        rows.push_back(std::move(row));
    }
    if (code != SQLITE_DONE) db.refuse(sqlite3_extended_errcode(db.handle));
    return rows;
}

Database::Value Database::value(const char* statement, const std::vector<Value>& values) {
    const auto rows = run(statement, values);
    return rows.empty() || rows.front().empty() ? Value() : rows.front().front();
}

std::int64_t Database::number(const char* statement, const std::vector<Value>& values) {
    const Value found = value(statement, values);
    const auto* number = std::get_if<std::int64_t>(&found);
    return number ? *number : 0;
}

Database::Transaction::Transaction(Database& database) : database_(database) {
    database_.run("BEGIN IMMEDIATE");
}

Database::Transaction::~Transaction() {
    // After some failures SQLite has rolled back already.
    if (open_) sqlite3_exec(database_.connection_->handle, "ROLLBACK", nullptr, nullptr, nullptr);
}

void Database::Transaction::commit() {
    database_.run("COMMIT");
    open_ = false;
}

}  // namespace vestige
