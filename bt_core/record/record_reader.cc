#include "bt_core/record/record_reader.h"

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <optional>
#include <utility>

#include "bt_core/frames/history_decoder.h"
#include "bt_core/frames/payload_coding.h"
#include "bt_core/record/record_cursor.h"
#include "bt_core/record/record_names.h"

namespace coppice {
namespace {

class TreeTaker final : public HistoryHandler {
 public:
  void OnTree(const TreeDescription& description) override { tree = description; }
  void OnState(const HistoryState&) override {}
  void OnTick(const TickEvents&) override {}
  std::optional<TreeDescription> tree;
};

std::optional<TreeDescription> ReadTree(FrameFile& file, const FrameFile::Span& span) {
  TreeTaker taker;
  const std::uint8_t* const frame = file.View(span.offset, span.size);
  if (!frame || !HistoryDecoder().Decode(frame, span.size, taker)) return std::nullopt;
  return std::move(taker.tree);
}

Decoder PayloadOf(FrameFile& file, const FrameFile::Span& span) {
  const std::uint8_t* const frame = file.View(span.offset, span.size);
  if (!frame) return {nullptr, nullptr};
  return {frame + kFrameHeaderSize, frame + span.size};
}

template <class T>
bool Keep(std::optional<T> value, std::vector<T>& all) {
  if (!value) return false;
  all.push_back(*std::move(value));
  return true;
}

// The run that a file is of; nothing if it does not begin with a tree.
std::optional<RunId> RunOf(const std::string& path) {
  FrameFile file(path);
  if (!file.error().empty()) return {};
  const FrameFile::Span span = file.Hop(kPreambleSize);
  if (span.size == 0 || span.type != static_cast<std::uint8_t>(FrameType::kTree)) return {};
  const std::optional<TreeDescription> tree = ReadTree(file, span);
  return tree ? std::optional(tree->info.run) : std::nullopt;
}

// What to do with a file of another program; empty if there is none.
std::string HowToRead(const std::string& path) {
  constexpr std::string_view kEnding = ".btlog";
  const bool is_btlog = path.size() > kEnding.size() &&
                        path.compare(path.size() - kEnding.size(), kEnding.size(), kEnding) == 0;
  std::error_code error;
  if (!is_btlog || !std::filesystem::is_regular_file(path, error)) return {};
  const std::string record = path.substr(0, path.size() - kEnding.size()) + ".coppice";
  return "\"coppice convert " + path + " " + record + "\" makes a record of this log";
}

}  // namespace

std::unique_ptr<RecordReader> RecordReader::Open(const std::string& path,
                                                 Diagnostics& diagnostics) {
  std::unique_ptr<RecordReader> reader(new RecordReader);
  const Outcome opened = reader->OpenSeries(path);
  if (opened) return reader;
  diagnostics.Error({path, 0, 0}, opened.problem(), HowToRead(path));
  return nullptr;
}

Outcome RecordReader::OpenSeries(const std::string& path) {
  const FrameFile file(path);
  if (!file.error().empty()) return Problem{file.error()};
  const std::optional<RunId> run = RunOf(path);
  for (const NumberedFile& found : FilesOfSeries(path)) {
    if (run && RunOf(found.path) == run) waiting_.push_back(found.path);
  }
  if (waiting_.empty()) waiting_.push_back(path);  // its beginning is damaged
  while (OpenNext()) Index();
  if (trees_.empty()) return Problem{"there is no whole description of a tree in this record"};
  if (keyframes_.empty()) return Problem{"there is no whole state of the tree in this record"};
  FindEnd();
  return {};
}

bool RecordReader::OpenNext() {
  if (waiting_.empty()) return false;
  if (torn_bytes_ > 0) AddDamage(offset_, std::exchange(torn_bytes_, 0));
  files_.push_back(waiting_.front());
  waiting_.pop_front();
  sizes_.push_back(kPreambleSize);
  file_ = std::make_unique<FrameFile>(files_.back());
  offset_ = kPreambleSize;
  continues_ = false;
  return true;
}

std::uint64_t RecordReader::size() const {
  return std::accumulate(sizes_.begin(), sizes_.end(), std::uint64_t{0});
}

// True if there was something new.
bool RecordReader::Index() {
  const std::uint64_t before = offset_;
  while (true) {
    const FrameFile::Span span = file_->Hop(offset_);
    if (span.size == 0) {
      torn_bytes_ = span.damaged;
      break;
    }
    if (span.damaged > 0) AddDamage(span.offset - span.damaged, span.damaged);
    offset_ = span.offset + span.size;
    if (!IndexFrame(span)) AddDamage(span.offset, span.size);
  }
  sizes_.back() = offset_;
  return offset_ != before;
}

// False if the frame is damaged; the events are not looked at.
bool RecordReader::IndexFrame(const FrameFile::Span& span) {
  const auto type = static_cast<FrameType>(span.type);
  if (type == FrameType::kEvents) return true;
  if (!file_->IsWholeAt(span)) return false;
  switch (type) {
    case FrameType::kTree:
      return IndexTree(span);
    case FrameType::kState:
      return IndexState(span);
    case FrameType::kGap:
      return Keep(DecodeGap(PayloadOf(*file_, span)), gaps_);
    case FrameType::kNote:
      return Keep(DecodeNote(PayloadOf(*file_, span)), notes_);
    default:
      return IndexEnd(DecodeEnd(PayloadOf(*file_, span)));
  }
}

bool RecordReader::IndexEnd(const std::optional<HistoryEnd>& end) {
  if (!end) return false;
  continues_ = end->cause == HistoryEnd::Cause::kContinued;
  closed_ = !continues_;
  return true;
}

bool RecordReader::IndexTree(const FrameFile::Span& span) {
  const std::uint32_t sum = ReadFrameHeader(file_->View(span.offset, kFrameHeaderSize)).crc;
  if (trees_.empty() || sum != tree_sum_) {
    std::optional<TreeDescription> tree = ReadTree(*file_, span);
    if (!tree) return false;
    trees_.push_back(*std::move(tree));
    tree_sum_ = sum;
  }
  const auto tree = static_cast<std::uint32_t>(trees_.size() - 1);
  tree_places_.push_back({file_number(), span.offset, tree});
  return true;
}

bool RecordReader::IndexState(const FrameFile::Span& span) {
  HistoryState state;
  Decoder payload = PayloadOf(*file_, span);
  if (trees_.empty() || !DecodeStateHead(payload, state)) return false;
  keyframes_.push_back({file_number(), static_cast<std::uint32_t>(trees_.size() - 1), span.offset,
                        state.tick, state.time});
  return true;
}

std::uint32_t RecordReader::TreeAt(std::uint32_t file, std::uint64_t offset) const {
  for (const TreePlace& place : tree_places_) {
    if (place.file == file && place.offset == offset) return place.tree;
  }
  return kNoTree;
}

void RecordReader::AddDamage(std::uint64_t offset, std::uint64_t bytes) {
  damages_.push_back({file_number(), offset, std::to_string(bytes) + " bytes are damaged"});
}

void RecordReader::FindEnd() {
  RecordCursor cursor(*this);
  cursor.SeekLast();
  last_tick_ = cursor.state().tick();
  end_ = cursor.state().time();
}

bool RecordReader::Refresh() {
  file_->Refresh();
  bool has_grown = Index();
  if (continues_) FindNewFiles();
  while (OpenNext()) has_grown |= Index();
  if (has_grown) FindEnd();
  return has_grown;
}

void RecordReader::FindNewFiles() {
  for (const NumberedFile& found : FilesOfSeries(files_.back())) {
    if (std::find(files_.begin(), files_.end(), found.path) != files_.end()) continue;
    if (RunOf(found.path) == trees_.front().info.run) waiting_.push_back(found.path);
  }
}

}  // namespace coppice
