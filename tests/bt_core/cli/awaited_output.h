// What a program prints on a stream, for a test that waits for a text in it.
#ifndef COPPICE_TESTS_BT_CORE_CLI_AWAITED_OUTPUT_H_
#define COPPICE_TESTS_BT_CORE_CLI_AWAITED_OUTPUT_H_

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <ostream>
#include <streambuf>
#include <string>

namespace coppice {

class AwaitedOutput : private std::streambuf {
 public:
  explicit AwaitedOutput(std::ostream& stream) : stream_(stream), before_(stream.rdbuf(this)) {}
  ~AwaitedOutput() override { stream_.rdbuf(before_); }

  /// False if it does not come within 30 s.
  bool Await(const std::string& text) {
    std::unique_lock<std::mutex> lock(mutex_);
    return came_.wait_for(lock, std::chrono::seconds(30),
                          [&] { return text_.find(text) != std::string::npos; });
  }
  std::string text() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return text_;
  }

 private:
  int_type overflow(int_type c) override {
    const char byte = static_cast<char>(c);
    xsputn(&byte, 1);
    return c;
  }
  std::streamsize xsputn(const char* text, std::streamsize size) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    text_.append(text, static_cast<std::size_t>(size));
    came_.notify_all();
    return size;
  }

  std::ostream& stream_;
  std::streambuf* const before_;
  mutable std::mutex mutex_;
  std::condition_variable came_;
  std::string text_;
};

}  // namespace coppice

#endif  // COPPICE_TESTS_BT_CORE_CLI_AWAITED_OUTPUT_H_
