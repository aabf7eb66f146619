// What a page has not and the C library of emscripten therefore leaves out. Callers are told so, as
// by a system that refuses it.
#include <pthread.h>

#include <cerrno>

// There are no threads.
extern "C" int pthread_setname_np(pthread_t, const char*) { return ENOSYS; }
