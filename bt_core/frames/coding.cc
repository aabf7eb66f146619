#include "bt_core/frames/coding.h"

#include <cstring>

namespace coppice {

void Encoder::Fixed32(std::uint32_t number) {
  for (int shift = 0; shift < 32; shift += 8) Byte(static_cast<std::uint8_t>(number >> shift));
}

void Encoder::Signed(std::int64_t number) {
  const auto bits = static_cast<std::uint64_t>(number);
  Unsigned(bits << 1 ^ (number < 0 ? ~std::uint64_t{0} : 0));
}

void Encoder::Double(double number) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &number, sizeof(bits));
  for (int shift = 0; shift < 64; shift += 8) Byte(static_cast<std::uint8_t>(bits >> shift));
}

void Encoder::Text(std::string_view text) {
  Unsigned(text.size());
  out_.insert(out_.end(), text.begin(), text.end());
}

bool Decoder::Need(std::uint64_t bytes) {
  if (bytes > static_cast<std::uint64_t>(end_ - at_)) Fail();
  return ok_;
}

void Decoder::Fail() {
  ok_ = false;
  at_ = end_;
}

std::uint8_t Decoder::Byte() { return Need(1) ? *at_++ : 0; }

std::uint32_t Decoder::Fixed32() {
  std::uint32_t number = 0;
  if (!Need(4)) return 0;
  for (int shift = 0; shift < 32; shift += 8) number |= std::uint32_t{*at_++} << shift;
  return number;
}

std::uint64_t Decoder::Unsigned() {
  std::uint64_t number = 0;
  for (int shift = 0; shift < 64; shift += 7) {
    const std::uint8_t byte = Byte();
    number |= std::uint64_t{byte & 0x7fu} << shift;
    if (byte < 0x80) return number;
  }
  Fail();
  return 0;
}

std::int64_t Decoder::Signed() {
  const std::uint64_t bits = Unsigned();
  return static_cast<std::int64_t>(bits >> 1 ^ (bits & 1 ? ~std::uint64_t{0} : 0));
}

double Decoder::Double() {
  std::uint64_t bits = 0;
  if (!Need(8)) return 0;
  for (int shift = 0; shift < 64; shift += 8) bits |= std::uint64_t{*at_++} << shift;
  double number = 0;
  std::memcpy(&number, &bits, sizeof(number));
  return number;
}

std::string Decoder::Text() { return std::string(View()); }

std::string_view Decoder::View() {
  const std::uint64_t size = Unsigned();
  if (!Need(size)) return {};
  const std::string_view text(reinterpret_cast<const char*>(at_), size);
  at_ += size;
  return text;
}

Decoder Decoder::Part() {
  const std::uint64_t size = Unsigned();
  if (!Need(size)) return {end_, end_};
  at_ += size;
  return {at_ - size, at_};
}

std::size_t Decoder::Count() {
  const std::uint64_t count = Unsigned();
  return Need(count) ? count : 0;
}

std::uint32_t Decoder::Index(std::size_t limit) {
  const std::uint64_t index = Unsigned();
  if (ok_ && index < limit) return static_cast<std::uint32_t>(index);
  Fail();
  return 0;
}

}  // namespace coppice
