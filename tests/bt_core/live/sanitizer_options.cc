// ZeroMQ is not compiled with the sanitizer, which therefore does not see how it hands messages
// from thread to thread and takes that for races.
extern "C" const char* __tsan_default_suppressions();  // NOLINT(bugprone-reserved-identifier)
extern "C" const char* __tsan_default_suppressions() {
  return "race:libzmq.so\ncalled_from_lib:libzmq.so\n";
}
