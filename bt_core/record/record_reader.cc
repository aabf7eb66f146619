#include "bt_core/record/record_reader.h"

#include <algorithm>
#include <utility>

#include "bt_core/history/frame.h"
#include "bt_core/record/entry_coding.h"

namespace coppice {
namespace {

template <class T>
std::optional<RecordEntry> AsEntry(std::optional<T> value) {
  if (!value) return std::nullopt;
  return RecordEntry(*std::move(value));
}

}  // namespace

std::optional<RecordReader> RecordReader::Open(const std::string& path, Diagnostics& diagnostics) {
  FileWindow file(path);
  if (!file.error().empty()) {
    diagnostics.Error({path, 0, 0}, "cannot read this file: " + file.error());
    return std::nullopt;
  }
  RecordReader reader(std::move(file));
  const std::string problem = reader.ReadHeader();
  if (problem.empty()) return reader;
  diagnostics.Error({path, 0, 0}, problem);
  return std::nullopt;
}

std::string RecordReader::ReadHeader() {
  const std::uint8_t* preamble = file_.View(0, kPreambleSize);
  if (!preamble || !std::equal(std::begin(kRecordMagic), std::end(kRecordMagic), preamble)) {
    return "not a Coppice record";
  }
  Decoder decoder(preamble + sizeof(kRecordMagic), preamble + kPreambleSize);
  const std::uint32_t version = decoder.Fixed32();
  if (version != kRecordVersion) {
    return "a record of version " + std::to_string(version) + "; this program reads version " +
           std::to_string(kRecordVersion);
  }
  const std::uint64_t size = FrameAt(kPreambleSize);
  if (size == 0) return "the header of this record, at byte 12, is cut off or damaged";
  const std::uint8_t* frame = file_.View(kPreambleSize, size);
  std::optional<RecordHeader> header;
  if (frame[4] == static_cast<std::uint8_t>(FrameType::kHeader)) {
    header = DecodeHeader(Decoder(frame + kFrameHeaderSize, frame + size));
  }
  if (!header) return "the header of this record, at byte 12, does not make sense";
  header_ = *std::move(header);
  offset_ = kPreambleSize + size;
  return "";
}

std::uint64_t RecordReader::FrameAt(std::uint64_t offset) {
  const std::uint8_t* start = file_.View(offset, kFrameHeaderSize);
  if (!start) return 0;
  const FrameHeader header = ReadFrameHeader(start);
  if (!IsPlausible(header)) return 0;
  const std::uint64_t size = kFrameHeaderSize + std::uint64_t{header.payload_size};
  const std::uint8_t* frame = file_.View(offset, size);
  return frame && IsWhole(frame, header) ? size : 0;
}

std::optional<RecordEntry> RecordReader::Next() {
  while (offset_ < file_.size()) {
    const std::uint64_t size = FrameAt(offset_);
    if (size == 0) {
      SkipDamage();
      continue;
    }
    std::optional<RecordEntry> entry = Decode(size);
    if (!entry) damages_.push_back({offset_, "a frame that does not make sense is left out"});
    offset_ += size;
    if (entry) return entry;
  }
  return std::nullopt;
}

// Frames stand for themselves, so reading goes on at the next whole one.
void RecordReader::SkipDamage() {
  std::uint64_t next = offset_ + 1;
  while (next < file_.size() && FrameAt(next) == 0) ++next;
  const std::string bytes = std::to_string(next - offset_) + " bytes";
  damages_.push_back({offset_, next < file_.size()
                                   ? bytes + " are damaged and left out"
                                   : "the last " + bytes + " are not a whole frame"});
  offset_ = next;
}

std::optional<RecordEntry> RecordReader::Decode(std::uint64_t frame_size) {
  const std::uint8_t* frame = file_.View(offset_, frame_size);
  if (!frame) return std::nullopt;
  const Decoder payload(frame + kFrameHeaderSize, frame + frame_size);
  switch (static_cast<FrameType>(frame[4])) {
    case FrameType::kTick:
      return AsEntry(DecodeTick(payload, header_));
    case FrameType::kNote:
      return AsEntry(DecodeNote(payload));
    case FrameType::kGap:
      return AsEntry(DecodeGap(payload, header_));
    case FrameType::kEnd:
      closed_ = true;
      return AsEntry(DecodeEnd(payload));
    case FrameType::kHeader:
      break;
  }
  return std::nullopt;
}

}  // namespace coppice
