#include "core/scene/store/CaseStore.h"

#include <chrono>
#include <utility>

#include "core/base/AtomicFile.h"
#include "core/base/Durable.h"
#include "core/base/Hash.h"
#include "core/base/UtcTime.h"
#include "core/base/Version.h"
#include "core/scene/casefile/CaseText.h"
#include "core/scene/store/Database.h"
#include "core/scene/store/Schema.h"

namespace vestige {
namespace {

namespace fs = std::filesystem;

/// States kept besides the last.
constexpr std::int64_t kKeptSaves = 10;
constexpr std::int64_t kKeptDrafts = 5;

std::int64_t moment() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
               std::chrono::system_clock::now().time_since_epoch())
        .count();
}

std::string hashOf(const std::string& text) {
    Sha256 sha;
    sha.add(text);
    return sha.hex();
}

/// A case.json that was not written here is somebody's work, or the case before there was a database.
bool isForeign(const fs::path& json, Database& database) {
    std::error_code unknown;
    if (!fs::exists(fs::symlink_status(json, unknown))) return false;
    if (!fs::is_regular_file(json, unknown)) return true;  // a pipe would be waited for
    const auto hash = sha256OfFile(json);
    return !hash || database.number("SELECT count(*) FROM saves WHERE sha256=?", {*hash}) == 0;
}

/// False when it stays where it is.
bool moveAside(const fs::path& json) {
    std::error_code error;
    fs::path kept = json;
    for (int number = 1; number == 1 || fs::exists(fs::symlink_status(kept, error)); ++number)
        kept = json.parent_path() / ("case-before-" + std::to_string(number) + ".json");
    fs::rename(json, kept, error);
    return !error;
}

}  // namespace

struct CaseStore::Data {
    std::mutex mutex;
    std::unique_ptr<CaseLock> lock;
    std::unique_ptr<Database> database;
};

CaseStore::CaseStore(fs::path folder, std::unique_ptr<Data> data)
    : folder_(std::move(folder)), data_(std::move(data)) {}
CaseStore::~CaseStore() {
    // The lock goes last.
    data_->database.reset();
}

Result<std::unique_ptr<CaseStore>> CaseStore::open(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        return fail(ErrorCode::output, "the folder cannot be made: " + error.message(), folder.string());
    CaseLock::Refusal refusal;
    auto lock = CaseLock::take(CaseLock::fileFor(folder), refusal);
    if (!lock) return fail(ErrorCode::output, refusal.sentence, folder.string());
    return open(folder, std::move(lock));
}

Result<std::unique_ptr<CaseStore>> CaseStore::open(const fs::path& folder, std::unique_ptr<CaseLock> lock) {
    auto data = std::make_unique<Data>();
    data->lock = std::move(lock);
    std::unique_ptr<CaseStore> store(new CaseStore(fs::absolute(folder).lexically_normal(), std::move(data)));
    const Status ready = store->attempt([](Database&) {});
    if (!ready) return fail(ready.error());
    return store;
}

/// Opens the database where it is not open. After a failure it is closed, so that the next attempt begins
/// with what is on the disk then.
template <class Work>
Status CaseStore::attempt(const Work& work) {
    const std::scoped_lock one(data_->mutex);
    auto& database = data_->database;
    const fs::path file = folder_ / "case.db";
    const Status done = guarded(file.string(), [&]() -> Status {
        std::error_code unknown;
        if (database && !fs::exists(file, unknown))
            return fail(ErrorCode::output, "the case's folder was moved or deleted", folder_.string());
        if (!database) {
            database = std::make_unique<Database>(file, Database::Access::write);
            prepareSchema(*database);
            syncFolder(folder_);
            syncFolder(folder_.parent_path());
        }
        work(*database);
        return {};
    });
    if (done) return done;
    database.reset();
    Error error = done.error();
    error.code = ErrorCode::output;
    return fail(error);
}

Status CaseStore::append(const std::vector<CaseEdit>& edits) {
    if (edits.empty()) return {};
    return attempt([&](Database& database) {
        const auto text = textInFolder(edits.back().state, folder_);
        if (!text) throw ErrorException{text.error()};
        Database::Transaction change(database);
        const std::int64_t base = lastSave(database);
        const std::string time = utcNow();
        for (std::size_t i = 0; i < edits.size(); ++i)
            database.run("INSERT INTO journal(time, moment, base, edit, case_text) VALUES(?, ?, ?, ?, ?)",
                         {time, moment(), base, edits[i].what,
                          i + 1 == edits.size() ? Database::Value(*text) : Database::Value()});
        database.run(
            "UPDATE journal SET case_text=NULL WHERE case_text IS NOT NULL AND (base<>?1 OR id NOT IN "
            "(SELECT id "
            "FROM journal WHERE case_text IS NOT NULL AND base=?1 ORDER BY id DESC LIMIT ?2))",
            {base, kKeptDrafts});
        change.commit();
    });
}

Status CaseStore::save(const SceneState& state) {
    return attempt([&](Database& database) {
        const auto text = textInFolder(state, folder_);
        if (!text) throw ErrorException{text.error()};
        const fs::path json = folder_ / "case.json";
        Database::Transaction change(database);
        const bool foreign = isForeign(json, database);
        database.run("INSERT INTO saves(time, program, case_text, sha256) VALUES(?, ?, ?, ?)",
                     {utcNow(), std::string("vestige ") + kVersion, *text, hashOf(*text)});
        database.run(
            "UPDATE saves SET case_text=NULL WHERE case_text IS NOT NULL AND id NOT IN (SELECT id FROM saves "
            "ORDER BY id DESC LIMIT ?)",
            {kKeptSaves});
        database.run("UPDATE journal SET case_text=NULL WHERE case_text IS NOT NULL");
        change.commit();
        // The case is saved, and only now may the file go that was the case before. A copy that cannot be
        // written now is written with the next save.
        if (!foreign || moveAside(json)) static_cast<void>(writeTextFile(json, *text));
    });
}

Status CaseStore::discard() {
    return attempt([&](Database& database) {
        Database::Transaction change(database);
        database.run("UPDATE journal SET case_text=NULL WHERE case_text IS NOT NULL");
        database.run(
            "INSERT INTO journal(time, moment, base, edit) VALUES(?, ?, -1, 'the edits since the last save "
            "were "
            "discarded')",
            {utcNow(), moment()});
        database.run("UPDATE journal SET base=-1 WHERE base=?", {lastSave(database)});
        change.commit();
    });
}

Status CaseStore::setCaseFile(const fs::path& file) {
    return attempt([&](Database& database) {
        database.run(
            "INSERT INTO facts(key, value) VALUES('case', ?1) ON CONFLICT(key) DO UPDATE SET value=?1",
            {file.string()});
    });
}

}  // namespace vestige
