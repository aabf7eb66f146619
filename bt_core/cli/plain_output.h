// What a terminal is shown of files of others: their names and texts may hold what it would obey.
#ifndef COPPICE_BT_CORE_CLI_PLAIN_OUTPUT_H_
#define COPPICE_BT_CORE_CLI_PLAIN_OUTPUT_H_

#include <iostream>
#include <streambuf>
#include <string>
#include <string_view>

namespace coppice {

/// The text with control characters written out ("\x1B"), but for ends of lines and tabs.
std::string Plain(std::string_view text);

/// While it lives, all that goes to std::cout is made plain.
class PlainOutput : private std::streambuf {
 public:
  PlainOutput() : output_(std::cout.rdbuf(this)) {}
  ~PlainOutput() override {
    const std::ios::iostate state = std::cout.rdstate();  // rdbuf() forgets what has failed
    std::cout.rdbuf(output_);
    std::cout.setstate(state);
  }

 private:
  std::streamsize xsputn(const char* text, std::streamsize size) override;
  int_type overflow(int_type character) override;
  int sync() override { return output_->pubsync(); }

  std::streambuf* const output_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_CLI_PLAIN_OUTPUT_H_
