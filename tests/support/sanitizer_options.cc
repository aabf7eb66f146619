// What the sanitizers are told, linked into every program that is compiled with one.

// Memory that was freed waits for so long before it is given out again: enough to find who still
// uses it, and little enough that tests may look at how much memory a program takes.
extern "C" const char* __asan_default_options();  // NOLINT(bugprone-reserved-identifier)
extern "C" const char* __asan_default_options() { return "quarantine_size_mb=16"; }

// libpqxx 6 forgets the answer to a statement during which the connection broke; espeak-ng keeps
// its list of voices until the end, now and then where nobody finds it.
extern "C" const char* __lsan_default_suppressions();  // NOLINT(bugprone-reserved-identifier)
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libpqxx-6.4.so\n"
         "leak:libespeak-ng.so\n";
}

// Libraries that are not compiled with the sanitizer, which therefore does not see how their
// threads hand things to each other and takes that for races. All of ZeroMQ and its encryption is
// left out; twice it gets no further than the standard library on the way from the I/O thread back
// to ZeroMQ, and those two functions must be named themselves. Of roscpp only what runs no callback
// of ours is named: connections and links, deserializing, its own threads, and the end of messages,
// callbacks and timers that it counts references of. The order of its locks (boost's, which we have
// nowhere), and of log4cxx's, is theirs. actionlib's client compares its state without its lock
// (SimpleActionClient::waitForResult); its server reads isPreemptRequested without, and at its end
// gives up what its callbacks use before it gives up the callbacks.
extern "C" const char* __tsan_default_suppressions();  // NOLINT(bugprone-reserved-identifier)
extern "C" const char* __tsan_default_suppressions() {
  return "race:libzmq.so\n"
         "race:libopencv_objdetect.so\n"
         "race:libcpp_common.so\n"
         "called_from_lib:libzmq.so\n"
         "called_from_lib:libsodium.so\n"
         "race:std::__cxx11::basic_string<char, *>::compare(char const*) const\n"
         "race:std::basic_streambuf<char, *>::xsputn(char const*, long)\n"
         "race:ros::CallbackQueue::addCallback\n"
         "race:ros::Connection::\n"
         "race:ros::ConnectionManager::\n"
         "race:ros::MessageDeserializer::\n"
         "race:ros::PollManager::\n"
         "race:ros::Publication::\n"
         "race:ros::PublisherLink::\n"
         "race:ros::ServiceServerLink::\n"
         "race:ros::Subscription::handleMessage\n"
         "race:ros::SubscriptionQueue::Item::~Item\n"
         "race:sp_counted_impl_pd<ros::Subscription::PendingConnection*\n"
         "race:ros::Transport\n"
         "race:ros::XMLRPCManager::\n"
         "race:std::vector<ros::SerializedMessage*>::~vector\n"
         "race:sp_counted_impl_pd<ros::TimerManager<*>::TimerInfo*\n"
         "race:actionlib::SimpleActionClient<*>::setSimpleState\n"
         "race:actionlib::SimpleActionServer<*>::isPreemptRequested\n"
         "race:actionlib::SimpleActionServer<*>::~SimpleActionServer\n"
         "deadlock:ros::\n"
         "deadlock:boost::unique_lock<boost::mutex>::lock\n"
         "deadlock:log4cxx::\n";
}
