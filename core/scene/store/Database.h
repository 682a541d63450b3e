#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace vestige {

/// An SQLite database, opened with what a file of unknown origin calls for: no triggers, views, extensions or
/// other files, values and work bounded. Every function throws an ErrorException (ErrorCode::input when
/// opened to read, else output) with the sentence that a user can act on. One thread at a time.
class Database {
  public:
    using Value = std::variant<std::monostate, std::int64_t, std::string>;
    using Row = std::vector<Value>;
    enum class Access { read, write };

    /// To write, the file is made where it is missing; what is committed is on the disk (rollback journal,
    /// synchronous=EXTRA: docs/decisions/0016-case-store.md). The folder must exist.
    Database(const std::filesystem::path& file, Access access);
    ~Database();
    Database(const Database&) = delete;
    Database& operator=(const Database&) = delete;

    const std::filesystem::path& file() const;
    /// One statement with its values in place of its question marks; what it returns.
    std::vector<Row> run(const char* statement, const std::vector<Value>& values = {});
    /// The first value of the first row; nothing in it when there is none.
    Value value(const char* statement, const std::vector<Value>& values = {});
    std::int64_t number(const char* statement, const std::vector<Value>& values = {});

    /// All or nothing: rolled back when destroyed before commit().
    class Transaction {
      public:
        explicit Transaction(Database& database);
        ~Transaction();
        Transaction(const Transaction&) = delete;
        Transaction& operator=(const Transaction&) = delete;
        void commit();

      private:
        Database& database_;
        bool open_ = true;
    };

  private:
    struct Connection;
    std::unique_ptr<Connection> connection_;
};

}  // namespace vestige
