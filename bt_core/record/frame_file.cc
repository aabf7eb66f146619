#include "bt_core/record/frame_file.h"

#include <algorithm>
#include <iterator>

namespace coppice {
namespace {

// How much a search for the next whole frame may read: bytes that look like frames again and again
// must not make it take for ever.
std::uint64_t SearchBudget(std::uint64_t bytes) { return (64 << 20) + 8 * bytes; }

}  // namespace

FrameFile::FrameFile(const std::string& path) : window_(path), error_(window_.error()) {
  if (!error_.empty()) {
    error_ = "cannot read this file: " + error_;
    return;
  }
  const std::uint8_t* preamble = window_.View(0, kPreambleSize);
  if (!preamble || !std::equal(std::begin(kRecordMagic), std::end(kRecordMagic), preamble)) {
    error_ = "not a Coppice record";
    return;
  }
  Decoder decoder(preamble + sizeof(kRecordMagic), preamble + kPreambleSize);
  const std::uint32_t version = decoder.Fixed32();
  if (version == kRecordVersion) return;
  error_ = "a record of version " + std::to_string(version) + "; this program reads version " +
           std::to_string(kRecordVersion);
}

FrameFile::Span FrameFile::Hop(std::uint64_t offset) {
  Span span = HeaderAt(offset);
  if (span.size == 0 && offset < size()) {
    // It may be the size of the frame before that is wrong.
    const bool is_behind = before_.size > 0 && before_.offset + before_.size == offset;
    const std::uint64_t from = is_behind && !IsWholeAt(before_) ? before_.offset + 1 : offset;
    span = Find(from);
    span.damaged += from == offset ? 0 : 1;
  }
  if (span.size > 0) before_ = span;
  return span;
}

FrameFile::Span FrameFile::Find(std::uint64_t offset) {
  std::uint64_t budget = SearchBudget(size() - std::min(offset, size()));
  for (std::uint64_t at = offset; at < size(); ++at) {
    Span span = HeaderAt(at);
    if (span.size == 0) continue;
    if (span.size > budget) break;
    budget -= span.size;
    if (!IsWholeAt(span)) continue;
    span.damaged = at - offset;
    return span;
  }
  return {size(), 0, 0, size() - std::min(offset, size())};
}

// Without size if there is no header that makes sense.
FrameFile::Span FrameFile::HeaderAt(std::uint64_t offset) {
  const std::uint8_t* bytes = window_.View(offset, kFrameHeaderSize);
  if (!bytes) return {};
  const FrameHeader header = ReadFrameHeader(bytes);
  const std::uint64_t size = kFrameHeaderSize + std::uint64_t{header.payload_size};
  if (!IsPlausible(header) || size > window_.size() - offset) return {};
  return {offset, size, header.type, 0};
}

bool FrameFile::IsWholeAt(const Span& span) {
  const std::uint8_t* bytes = window_.View(span.offset, span.size);
  return bytes && IsWhole(bytes, ReadFrameHeader(bytes));
}

}  // namespace coppice
