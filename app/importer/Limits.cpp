#include "app/importer/Limits.h"

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <iterator>
#include <vector>

namespace vestige::importer {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

void limit(__rlimit_resource what, std::uint64_t most) {
    const rlimit values{most, most};
    ::setrlimit(what, &values);
}

}  // namespace

void limitProcess(std::uint64_t memoryBytes, std::uint64_t seconds) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    ::prctl(PR_SET_DUMPABLE, 0);
    if (!kSanitized) limit(RLIMIT_AS, memoryBytes);
    limit(RLIMIT_CPU, seconds);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, 0);
}

void closeDoors() {
    if (kSanitized) return;
    constexpr std::uint32_t kClosed[] = {
        SYS_execve,           SYS_execveat, SYS_fork,   SYS_vfork,    SYS_clone,  SYS_clone3,   SYS_socket,
        SYS_socketpair,       SYS_connect,  SYS_ptrace, SYS_kill,     SYS_tkill,  SYS_open,     SYS_openat,
        SYS_openat2,          SYS_creat,    SYS_unlink, SYS_unlinkat, SYS_rename, SYS_renameat, SYS_renameat2,
        SYS_process_vm_writev};
    constexpr std::size_t kCount = std::size(kClosed);
    std::vector<sock_filter> program{
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, arch)),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, AUDIT_ARCH_X86_64, 1, 0),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS),
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
        // The same calls under the numbers of the x32 interface.
        BPF_JUMP(BPF_JMP | BPF_JGE | BPF_K, 0x40000000, static_cast<__u8>(kCount + 1), 0),
    };
    for (std::size_t i = 0; i < kCount; ++i)
        program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, kClosed[i], static_cast<__u8>(kCount - i), 0));
    program.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
    program.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EACCES));
    const sock_fprog filter{static_cast<unsigned short>(program.size()), program.data()};
    // Where the kernel has no filters the limits above still hold.
    if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0)
        ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter, 0, 0);
}

}  // namespace vestige::importer
