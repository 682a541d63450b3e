#pragma once

#include <filesystem>

namespace vestige {

/// SQLite believes the files that it expects beside a database ("-journal", "-wal", "-shm"): it plays them
/// back, writes through links, and deletes the file that the end of a journal names as its super-journal (for
/// changes of several databases, which no case makes). A case may come from anybody, so before its database
/// is opened they must be plain files of one name, and the journal must name no other file. Throws an
/// ErrorException (ErrorCode::input).
void checkSideFiles(const std::filesystem::path& database);

}  // namespace vestige
