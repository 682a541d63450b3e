#pragma once

#include <filesystem>
#include <memory>
#include <string>

namespace vestige {

/// Keeps a case to one window: a lock (flock) on a file, which ends with the process that holds it, however
/// that ends; the file's text only says who. A file that a killed process left is no lock.
class CaseLock {
  public:
    /// Why a case is not to be had.
    struct Refusal {
        std::string sentence;    ///< who has it open, or why it cannot be written; empty: it was had
        bool elsewhere = false;  ///< another window has it open
    };
    /// Null when the case is not to be had.
    static std::unique_ptr<CaseLock> take(const std::filesystem::path& file, Refusal& refusal);
    /// Removes the file and ends the lock.
    ~CaseLock();
    CaseLock(const CaseLock&) = delete;
    CaseLock& operator=(const CaseLock&) = delete;

    /// The file beside a case (casePlace) that its lock is on.
    static std::filesystem::path fileFor(const std::filesystem::path& place);

  private:
    CaseLock(std::filesystem::path file, int descriptor) : file_(std::move(file)), descriptor_(descriptor) {}
    std::filesystem::path file_;
    int descriptor_;
};

}  // namespace vestige
