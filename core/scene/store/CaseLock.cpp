#include "core/scene/store/CaseLock.h"

#include <fcntl.h>
#include <pwd.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <sstream>

#include "core/base/UtcTime.h"
#include "core/scene/CaseFile.h"

namespace vestige {
namespace {

namespace fs = std::filesystem;

std::string hostName() {
    std::array<char, 256> host{};
    ::gethostname(host.data(), host.size() - 1);
    return host.data();
}

std::string userName() {
    passwd entry{};
    passwd* found = nullptr;
    std::array<char, 4096> buffer{};
    if (::getpwuid_r(::geteuid(), &entry, buffer.data(), buffer.size(), &found) == 0 && found)
        return found->pw_name;
    return "user " + std::to_string(::geteuid());
}

/// One fact a line: process, user, host, time.
void writeOwner(int descriptor) {
    const std::string text =
        std::to_string(::getpid()) + "\n" + userName() + "\n" + hostName() + "\n" + utcNow() + "\n";
    // Nobody depends on it: the lock is what counts. A file of several names is somebody's data.
    struct stat status {};
    if (::fstat(descriptor, &status) != 0 || status.st_nlink != 1) return;
    if (::ftruncate(descriptor, 0) == 0)
        static_cast<void>(::pwrite(descriptor, text.data(), text.size(), 0) == 0);
}

std::string ownerIn(int descriptor) {
    std::array<char, 512> text{};
    const auto count = ::pread(descriptor, text.data(), text.size(), 0);
    std::istringstream lines(std::string(text.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0))));
    std::string process, user, host, since;
    if (!std::getline(lines, process) || !std::getline(lines, user) || !std::getline(lines, host) ||
        !std::getline(lines, since))
        return "another window has this case open";
    return "this case has been open in another window since " + since + " (" + user + " on " + host +
           ", process " + process + ")";
}

bool isStillAt(const fs::path& file, int descriptor) {
    struct stat open {
    }, named{};
    return ::fstat(descriptor, &open) == 0 && ::stat(file.c_str(), &named) == 0 &&
           open.st_ino == named.st_ino && open.st_dev == named.st_dev;
}

}  // namespace

fs::path CaseLock::fileFor(const fs::path& place) {
    if (isCaseStore(place)) return place / "lock";
    return place.parent_path() / ("." + place.filename().string() + ".lock");
}

std::unique_ptr<CaseLock> CaseLock::take(const fs::path& file, Refusal& refusal) {
    for (int attempt = 0; attempt < 100; ++attempt) {
        bool writable = true;
        constexpr int kFlags = O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK;
        int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | kFlags, 0666);
        if (descriptor < 0) {
            writable = false;
            refusal = {std::string("the case cannot be written here: ") + std::strerror(errno), false};
            descriptor = ::open(file.c_str(), O_RDONLY | kFlags);
            if (descriptor < 0) return nullptr;
        }
        if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && (errno == EWOULDBLOCK || errno == EINTR)) {
            refusal = {ownerIn(descriptor), true};
            ::close(descriptor);
            return nullptr;
        }
        // A file system without locks: then there is no protection, but the case can be worked on.
        if (writable && isStillAt(file, descriptor)) {
            writeOwner(descriptor);
            refusal = {};
            return std::unique_ptr<CaseLock>(new CaseLock(file, descriptor));
        }
        ::close(descriptor);
        if (!writable) return nullptr;
        // Its owner removed it between our opening and locking it: there is a new one, or none.
    }
    refusal = {"the lock of this case cannot be had", false};
    return nullptr;
}

CaseLock::~CaseLock() {
    if (isStillAt(file_, descriptor_)) ::unlink(file_.c_str());
    ::close(descriptor_);
}

}  // namespace vestige
