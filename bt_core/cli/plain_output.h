// Standard output that a terminal may be shown, whatever was written to it.
#ifndef COPPICE_BT_CORE_CLI_PLAIN_OUTPUT_H_
#define COPPICE_BT_CORE_CLI_PLAIN_OUTPUT_H_

#include <iostream>
#include <streambuf>
#include <string>

namespace coppice {

/// While it lives, all that goes to std::cout is made plain (bt_core/base/plain.h).
class PlainOutput : private std::streambuf {
 public:
  PlainOutput() : output_(std::cout.rdbuf(this)) {}
  ~PlainOutput() override;

 private:
  std::streamsize xsputn(const char* text, std::streamsize size) override;
  int_type overflow(int_type character) override;
  int sync() override;
  bool Write(const std::string& text);

  std::streambuf* const output_;
  std::string begun_;  // a character of which only the first byte was written yet
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_CLI_PLAIN_OUTPUT_H_
