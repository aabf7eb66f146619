// What the sanitizers are told, linked into every program that is compiled with one.

// Memory that was freed waits for so long before it is given out again: enough to find who still
// uses it, and little enough that tests may look at how much memory a program takes.
extern "C" const char* __asan_default_options();  // NOLINT(bugprone-reserved-identifier)
extern "C" const char* __asan_default_options() { return "quarantine_size_mb=16"; }

// ZeroMQ and its encryption are not compiled with the sanitizer, which therefore does not see how
// messages are handed from thread to thread and takes that for races. Twice it gets no further than
// the standard library on the way from the I/O thread back to ZeroMQ; those two functions must be
// named themselves.
extern "C" const char* __tsan_default_suppressions();  // NOLINT(bugprone-reserved-identifier)
extern "C" const char* __tsan_default_suppressions() {
  return "race:libzmq.so\n"
         "called_from_lib:libzmq.so\n"
         "called_from_lib:libsodium.so\n"
         "race:std::__cxx11::basic_string<char, *>::compare(char const*) const\n"
         "race:std::basic_streambuf<char, *>::xsputn(char const*, long)\n";
}
