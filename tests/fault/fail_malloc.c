/* Preloaded: the allocation of number FAIL_MALLOC_AT, counted from 1, fails. FAIL_MALLOC_COUNT names a file for the number of allocations; with FAIL_MALLOC_TRACE the calls that lead
   to the failing allocation are written to standard error. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <execinfo.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>

extern void* __libc_malloc(size_t);
extern void* __libc_calloc(size_t, size_t);
extern void* __libc_realloc(void*, size_t);
extern void* __libc_memalign(size_t, size_t);

static atomic_long made, at = -1;
static int trace;

__attribute__((constructor)) static void begin(void) {
  const char* text = getenv("FAIL_MALLOC_AT");
  trace = getenv("FAIL_MALLOC_TRACE") != NULL;
  void* here[1];
  if (trace) backtrace(here, 1); /* loads the library that backtrace() needs */
  atomic_store(&made, 0);
  atomic_store(&at, text ? atol(text) : 0);
}

__attribute__((destructor)) static void end(void) {
  const char* name = getenv("FAIL_MALLOC_COUNT");
  const long all = atomic_load(&made);
  FILE* file = name ? fopen(name, "w") : NULL;
  if (file == NULL) return;
  fprintf(file, "%ld\n", all);
  fclose(file);
}

static int fails(void) {
  const long number = atomic_fetch_add(&made, 1) + 1;
  if (number != atomic_load(&at)) return 0;
  if (trace) {
    void* calls[40];
    backtrace_symbols_fd(calls, backtrace(calls, 40), 2);
  }
  errno = ENOMEM;
  return 1;
}

void* malloc(size_t size) { return fails() ? NULL : __libc_malloc(size); }
void* calloc(size_t n, size_t size) { return fails() ? NULL : __libc_calloc(n, size); }
void* realloc(void* old, size_t size) { return fails() ? NULL : __libc_realloc(old, size); }
void* memalign(size_t to, size_t size) { return fails() ? NULL : __libc_memalign(to, size); }
void* aligned_alloc(size_t to, size_t size) { return fails() ? NULL : __libc_memalign(to, size); }
int posix_memalign(void** out, size_t to, size_t size) {
  if (fails()) return ENOMEM;
  *out = __libc_memalign(to, size);
  return *out == NULL ? ENOMEM : 0;
}
