// SPDX-License-Identifier: MIT
// Preloaded (LD_PRELOAD) into a program, makes its N-th call of a kind fail, as a full memory or disk would; the first
// one is the first after main began. Environment:
//
//   LUMI_FAULT        KIND:N, KIND:N:kill (the process is killed before the call), KIND:N:wait (the call takes 3 s
//                     and does not fail) or KIND:N:done (it is done and says ENOENT, as a rename on NFS does whose
//                     answer was lost). KIND: alloc, read, write, sync, rename, link (of readlink), thread.
//                     From alloc:N on every allocation may be asked again: only the N-th fails. From thread:N and
//                     link:N on the system gives none.
//   LUMI_FAULT_COUNT  a file that gets how many calls of each kind there were, "KIND COUNT" a line, when the program
//                     exits
//
// Calls of other threads count, too. The numbers are stable where the program is: run it with one thread.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <pthread.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <unistd.h>

enum Kind { kAlloc, kRead, kWrite, kSync, kRename, kLink, kThread, kKinds };
static const char* const kNames[kKinds] = {"alloc", "read", "write", "sync", "rename", "link", "thread"};

static atomic_ulong counts[kKinds];
static unsigned long fail_at[kKinds];
static int armed, kills, waits, does;

// Whether this call is the one that fails.
static int fails(enum Kind kind)
{
    if (!armed) return 0;
    const unsigned long n = 1 + atomic_fetch_add(&counts[kind], 1);
    if (kind == kThread || kind == kLink ? fail_at[kind] == 0 || n < fail_at[kind] : n != fail_at[kind]) return 0;
    if (kills) kill(getpid(), SIGKILL);
    if (waits) return sleep(3), 0;
    return 1;
}

static void* next(const char* name)
{
    return dlsym(RTLD_NEXT, name);
}

// dlsym may allocate: the allocators behind malloc are named without it.
void* __libc_malloc(size_t);
void* __libc_calloc(size_t, size_t);
void* __libc_realloc(void*, size_t);

void* malloc(size_t size)
{
    if (fails(kAlloc)) return errno = ENOMEM, NULL;
    return __libc_malloc(size);
}
void* calloc(size_t count, size_t size)
{
    if (fails(kAlloc)) return errno = ENOMEM, NULL;
    return __libc_calloc(count, size);
}
void* realloc(void* block, size_t size)
{
    if (fails(kAlloc)) return errno = ENOMEM, NULL;
    return __libc_realloc(block, size);
}

#define WRAPPED(result, name, kind, error, parameters, arguments) \
    result name parameters                                        \
    {                                                             \
        static result(*original) parameters;                      \
        if (!original) *(void**)&original = next(#name);          \
        if (fails(kind)) {                                        \
            if (does) original arguments;                         \
            return errno = does ? ENOENT : (error), -1;           \
        }                                                         \
        return original arguments;                                \
    }

WRAPPED(ssize_t, read, kRead, EIO, (int file, void* out, size_t size), (file, out, size))
WRAPPED(ssize_t, pread, kRead, EIO, (int file, void* out, size_t size, off_t at), (file, out, size, at))
WRAPPED(ssize_t, pread64, kRead, EIO, (int file, void* out, size_t size, off64_t at), (file, out, size, at))
WRAPPED(ssize_t, write, kWrite, ENOSPC, (int file, const void* in, size_t size), (file, in, size))
WRAPPED(ssize_t, pwrite, kWrite, ENOSPC, (int file, const void* in, size_t size, off_t at), (file, in, size, at))
WRAPPED(ssize_t, pwrite64, kWrite, ENOSPC, (int file, const void* in, size_t size, off64_t at), (file, in, size, at))
WRAPPED(int, fsync, kSync, EIO, (int file), (file))
WRAPPED(int, fdatasync, kSync, EIO, (int file), (file))
WRAPPED(int, rename, kRename, EACCES, (const char* from, const char* to), (from, to))
WRAPPED(ssize_t, readlink, kLink, ENOENT, (const char* path, char* out, size_t size), (path, out, size))

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*begin)(void*), void* argument)
{
    static int (*original)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
    if (!original) *(void**)&original = next("pthread_create");
    return fails(kThread) ? EAGAIN : original(thread, attributes, begin, argument);
}

static void read_environment(void)
{
    const char* fault = getenv("LUMI_FAULT");
    for (int kind = 0; fault && kind < kKinds; ++kind) {
        const size_t length = strlen(kNames[kind]);
        if (strncmp(fault, kNames[kind], length) == 0 && fault[length] == ':') {
            char* end = NULL;
            fail_at[kind] = strtoul(fault + length + 1, &end, 10);
            kills = strcmp(end, ":kill") == 0;
            waits = strcmp(end, ":wait") == 0;
            does = strcmp(end, ":done") == 0;
        }
    }
}

static void say_counts(void)
{
    armed = 0;
    FILE* out = fopen(getenv("LUMI_FAULT_COUNT"), "w");
    for (int kind = 0; out && kind < kKinds; ++kind) fprintf(out, "%s %lu\n", kNames[kind], counts[kind]);
    if (out) fclose(out);
}

static int (*real_main)(int, char**, char**);

static int armed_main(int argc, char** argv, char** environment)
{
    read_environment();
    if (getenv("LUMI_FAULT_COUNT")) atexit(say_counts);
    armed = 1;
    const int code = real_main(argc, argv, environment);
    armed = 0;
    return code;
}

int __libc_start_main(int (*main)(int, char**, char**), int argc, char** argv, void (*init)(void), void (*fini)(void),
                      void (*rtld_fini)(void), void* stack_end)
{
    int (*original)(int (*)(int, char**, char**), int, char**, void (*)(void), void (*)(void), void (*)(void), void*);
    *(void**)&original = next("__libc_start_main");
    real_main = main;
    return original(armed_main, argc, argv, init, fini, rtld_fini, stack_end);
}
