#include "bt_core/cli/plain_output.h"

#include <utility>

#include "bt_core/base/plain.h"

namespace coppice {

PlainOutput::~PlainOutput() {
  std::ios::iostate state = std::cout.rdstate();  // rdbuf() forgets what has failed
  if (!Write(std::exchange(begun_, ""))) state |= std::ios::badbit;
  std::cout.rdbuf(output_);
  std::cout.setstate(state);
}

std::streamsize PlainOutput::xsputn(const char* text, std::streamsize size) {
  std::string whole = std::exchange(begun_, "");
  whole.append(text, static_cast<std::size_t>(size));
  if (!whole.empty() && whole.back() == '\xC2') {
    begun_ = whole.back();
    whole.pop_back();
  }
  return Write(Plain(whole)) ? size : 0;
}

PlainOutput::int_type PlainOutput::overflow(int_type character) {
  const char c = traits_type::to_char_type(character);
  return xsputn(&c, 1) == 1 ? character : traits_type::eof();
}

int PlainOutput::sync() {
  const bool is_written = Write(std::exchange(begun_, ""));
  return is_written ? output_->pubsync() : -1;
}

bool PlainOutput::Write(const std::string& text) {
  const auto length = static_cast<std::streamsize>(text.size());
  return output_->sputn(text.data(), length) == length;
}

}  // namespace coppice
