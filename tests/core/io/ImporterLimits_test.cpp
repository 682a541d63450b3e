#include <asm/ioctls.h>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <new>
#include <vector>

#include <gtest/gtest.h>

#include "app/importer/Limits.h"
#include "tests/core/io/Clouds.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

/// The importer's limits, in a process of its own; what `work` returns is how it ends.
int endUnderLimits(const std::function<int()>& work) {
    const pid_t child = ::fork();
    if (child == 0) {
        importer::limitProcess(std::uint64_t{512} << 20, 5);
        importer::closeDoors();
        ::_exit(work());
    }
    int status = -1;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    return status;
}

/// The number of the first thing that could be done none the less.
int firstOpenDoor(const char* file, int opened) {
    const auto denied = [](long result) { return result < 0 && errno == EACCES; };
    if (!denied(::open(file, O_RDONLY | O_CLOEXEC))) return 1;
    if (!denied(::socket(AF_INET, SOCK_STREAM, 0))) return 2;
    if (!denied(::fork())) return 3;
    char program[] = "/bin/true";
    char* const words[] = {program, nullptr};
    if (!denied(::execv(program, words))) return 4;
    if (!denied(::unlink(file))) return 5;
    if (!denied(::kill(::getppid(), 0))) return 6;
    if (::write(opened, "x", 1) >= 0) return 7;
    try {
        const std::vector<char> large(std::size_t{1} << 30);
        return large.empty() ? 9 : 8;
    } catch (const std::bad_alloc&) {
        return 0;
    }
}

/// Calls that change a file by its name or through its descriptor, reach another process, or open ways to
/// both; the number of the first one that is not denied, or 0.
int firstCallAllowed(const char* file, const char* other, int opened) {
    const auto parent = static_cast<long>(::getppid());
    const auto path = reinterpret_cast<long>(file), second = reinterpret_cast<long>(other);
    const std::array<long, 7> calls[] = {
        {SYS_truncate, path, 0},
        {SYS_ftruncate, opened, 0},
        {SYS_fallocate, opened, 0, 0, 10},
        {SYS_mkdir, second, 0700},
        {SYS_mkdirat, AT_FDCWD, second, 0700},
        {SYS_rmdir, second},
        {SYS_link, path, second},
        {SYS_linkat, AT_FDCWD, path, AT_FDCWD, second, 0},
        {SYS_symlink, path, second},
        {SYS_symlinkat, path, AT_FDCWD, second},
        {SYS_mknod, second, 0600, 0},
        {SYS_mknodat, AT_FDCWD, second, 0600, 0},
        {SYS_rename, path, second},
        {SYS_chmod, path, 0777},
        {SYS_fchmod, opened, 0777},
        {SYS_fchmodat, AT_FDCWD, path, 0777},
        {SYS_chown, path, -1, -1},
        {SYS_fchownat, AT_FDCWD, path, -1, -1, 0},
        {SYS_utimensat, AT_FDCWD, path, 0, 0},
        {SYS_setxattr, path, reinterpret_cast<long>("user.a"), path, 1, 0},
        {SYS_openat2, AT_FDCWD, path, 0, 0},
        {SYS_open_by_handle_at, AT_FDCWD, 0, 0},
        {SYS_stat, path, 0},
        {SYS_readlink, path, 0, 0},
        {SYS_tkill, parent, 0},
        {SYS_tgkill, parent, parent, 0},
        {SYS_rt_sigqueueinfo, parent, 0, 0},
        {SYS_pidfd_open, parent, 0},
        {SYS_pidfd_send_signal, opened, 0, 0, 0},
        {SYS_process_vm_readv, parent, 0, 0, 0, 0, 0},
        {SYS_process_vm_writev, parent, 0, 0, 0, 0, 0},
        {SYS_ptrace, 0, 0, 0, 0},
        {SYS_prlimit64, parent, RLIMIT_CPU, 0, 0},
        {SYS_fcntl, opened, F_SETOWN, parent},
        {SYS_ioctl, opened, FIOASYNC, 0},
        {SYS_io_uring_setup, 1, 0},
        {SYS_userfaultfd, 0},
        {SYS_bpf, 0, 0, 0},
        {SYS_memfd_create, path, 0},
        {SYS_clone3, 0, 0},
        {SYS_read | 0x40000000, opened, 0, 0},  // by the numbers of the x32 interface
        {100000},                               // of a kernel to come
    };
    for (const auto& [number, a, b, c, d, e, f] : calls)
        if (::syscall(number, a, b, c, d, e, f) >= 0 || errno != EACCES)
            return static_cast<int>(number % 250);
    return 0;
}

}  // namespace

TEST(ImporterLimits, LeaveNoDoorOpen) {
    if (importer::kSanitized) GTEST_SKIP() << "skipped: sanitizers cannot run under these limits";
    const TemporaryFolder folder;
    const auto file = folder / "file", other = folder / "other";
    writeBytes(file, "evidence");
    const int opened = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
    ASSERT_GE(opened, 0);
    struct stat before {
    }, after{};
    ASSERT_EQ(::stat(file.c_str(), &before), 0);
    const auto previous = ::signal(SIGXFSZ, SIG_IGN);
    const int doors = endUnderLimits([&] { return firstOpenDoor(file.c_str(), opened); });
    ::signal(SIGXFSZ, previous);
    EXPECT_TRUE(WIFEXITED(doors) && WEXITSTATUS(doors) == 0) << doors;
    const int calls = endUnderLimits([&] { return firstCallAllowed(file.c_str(), other.c_str(), opened); });
    EXPECT_TRUE(WIFEXITED(calls)) << calls;
    EXPECT_EQ(WEXITSTATUS(calls), 0) << "the number of a system call";
    ::close(opened);
    ASSERT_EQ(::stat(file.c_str(), &after), 0);
    EXPECT_EQ(after.st_size, 8);
    EXPECT_EQ(after.st_mode, before.st_mode);
    EXPECT_EQ(after.st_nlink, 1U);
    EXPECT_FALSE(std::filesystem::exists(other));
}

TEST(ImporterLimits, ALibraryThatAbortsDiesOfThat) {
    if (importer::kSanitized) GTEST_SKIP() << "skipped: sanitizers cannot run under these limits";
    const int status = endUnderLimits([]() -> int { std::abort(); });
    ASSERT_TRUE(WIFSIGNALED(status)) << status;
    EXPECT_EQ(WTERMSIG(status), SIGABRT);
}
