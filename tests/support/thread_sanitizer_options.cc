// ZeroMQ, its encryption and ROS are not compiled with the sanitizer, which therefore does not see
// how messages and reference counts are handed from thread to thread in them and takes that for
// races. Twice it gets no further than the standard library on the way from ZeroMQ's I/O thread
// back; those two functions must be named themselves.
extern "C" const char* __tsan_default_suppressions();  // NOLINT(bugprone-reserved-identifier)
extern "C" const char* __tsan_default_suppressions() {
  return "race:libzmq.so\n"
         "called_from_lib:libzmq.so\n"
         "called_from_lib:libsodium.so\n"
         "race:std::__cxx11::basic_string<char, *>::compare(char const*) const\n"
         "race:std::basic_streambuf<char, *>::xsputn(char const*, long)\n"
         "called_from_lib:libroscpp.so\n"
         "called_from_lib:libxmlrpcpp.so\n"
         "called_from_lib:librosconsole.so\n";
}
