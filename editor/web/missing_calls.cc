// What a page has not and the C library of emscripten therefore leaves out. Callers are told so, as
// by a system that refuses it.
#include <pthread.h>

#include <cerrno>
#include <cstdio>

extern "C" {

// There are no other programs.
FILE* popen(const char*, const char*) {
  errno = ENOSYS;
  return nullptr;
}
int pclose(FILE*) {
  errno = ECHILD;
  return -1;
}

// There are no threads.
int pthread_setname_np(pthread_t, const char*) { return ENOSYS; }
}
