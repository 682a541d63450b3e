#include "app/importer/Limits.h"

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <iterator>
#include <vector>

namespace vestige::importer {
namespace {

/// All that reading needs: what lies in memory and in open descriptors, and an end. Nothing here reaches a
/// file, a process or a setting outside. Not among them although they look harmless: fcntl (F_SETOWN has the
/// kernel send signals to others) and prlimit64 (sets the limits of others).
constexpr std::uint32_t kAllowed[] = {
    SYS_read,          SYS_write,           SYS_lseek,  SYS_fstat,        SYS_close,
    SYS_mmap,          SYS_munmap,          SYS_mremap, SYS_mprotect,     SYS_madvise,
    SYS_brk,           SYS_futex,           SYS_getpid, SYS_gettid,       SYS_getrandom,
    SYS_clock_gettime, SYS_gettimeofday,    SYS_time,   SYS_rt_sigaction, SYS_rt_sigprocmask,
    SYS_rt_sigreturn,  SYS_restart_syscall, SYS_exit,   SYS_exit_group};

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
    std::vector<sock_filter> program{
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, arch)),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, AUDIT_ARCH_X86_64, 1, 0),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS),
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
    };
    constexpr std::size_t kCount = std::size(kAllowed);
    for (std::size_t i = 0; i < kCount; ++i)
        program.push_back(
            BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, kAllowed[i], static_cast<__u8>(kCount - i + 3), 0));
    // abort() sends its signal to this process itself.
    program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_tgkill, 0, 2));
    program.push_back(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, args)));
    program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<__u32>(::getpid()), 1, 0));
    program.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EACCES));
    program.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
    const sock_fprog filter{static_cast<unsigned short>(program.size()), program.data()};
    // Where the kernel has no filters the limits above still hold.
    if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0)
        ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter, 0, 0);
}

}  // namespace vestige::importer
