#include "editor/files/history_bytes.h"

#include <algorithm>
#include <utility>

#include "bt_core/frames/coding.h"
#include "bt_core/frames/crc32c.h"

namespace coppice::editor {
namespace {

constexpr char kMagic[] = "coppice undo history 1\n";

void Write(const Edit& edit, Encoder& out) {
  out.Unsigned(edit.size());
  for (const Splice& splice : edit) {
    out.Unsigned(splice.offset);
    out.Unsigned(splice.removed);
    out.Text(splice.inserted);
  }
}

void Write(const std::vector<Edit>& edits, Encoder& out) {
  out.Unsigned(edits.size());
  for (const Edit& edit : edits) Write(edit, out);
}

void Write(const std::vector<FilePlace>& places, Encoder& out) {
  out.Unsigned(places.size());
  for (const FilePlace& place : places) {
    out.Text(place.path);
    out.Unsigned(place.offset);
  }
}

Bytes Write(const Step& step) {
  Bytes bytes;
  Encoder out(bytes);
  out.Text(step.name);
  out.Unsigned(step.files.size());
  for (const FileStep& file : step.files) {
    out.Text(file.path);
    Write(file.forward, out);
    Write(file.back, out);
  }
  Write(step.selected_before, out);
  Write(step.selected_after, out);
  return bytes;
}

// Reads a list of things; the count is checked against what is left.
template <class T, class ReadOne>
std::vector<T> ReadList(Decoder& in, ReadOne read_one) {
  std::vector<T> list;
  const std::size_t count = in.Count();
  for (std::size_t i = 0; i < count && in.ok(); ++i) list.push_back(read_one(in));
  return list;
}

Splice ReadSplice(Decoder& in) {
  Splice splice;
  splice.offset = static_cast<std::uint32_t>(in.Unsigned());
  splice.removed = static_cast<std::uint32_t>(in.Unsigned());
  splice.inserted = in.Text();
  return splice;
}

std::vector<Edit> ReadEdits(Decoder& in) {
  return ReadList<Edit>(in, [](Decoder& d) { return ReadList<Splice>(d, ReadSplice); });
}

std::vector<FilePlace> ReadPlaces(Decoder& in) {
  return ReadList<FilePlace>(in, [](Decoder& d) {
    FilePlace place;
    place.path = d.Text();
    place.offset = static_cast<std::uint32_t>(d.Unsigned());
    return place;
  });
}

Step ReadStep(Decoder& in) {
  Step step;
  step.name = in.Text();
  step.files = ReadList<FileStep>(in, [](Decoder& d) {
    FileStep file;
    file.path = d.Text();
    file.forward = ReadEdits(d);
    file.back = ReadEdits(d);
    return file;
  });
  step.selected_before = ReadPlaces(in);
  step.selected_after = ReadPlaces(in);
  return step;
}

// The range of steps around `done` that fits, the done ones first: a long list of undone steps does
// not push them out.
struct Range {
  std::size_t begin;
  std::size_t end;
};
Range FittingRange(const std::vector<Bytes>& steps, std::size_t done, std::size_t limit) {
  Range range = {done, done};
  while (range.begin > 0 && steps[range.begin - 1].size() <= limit) {
    limit -= steps[--range.begin].size();
  }
  while (range.end < steps.size() && steps[range.end].size() <= limit) {
    limit -= steps[range.end++].size();
  }
  return range;
}

}  // namespace

KnownText DescribeText(std::string path, std::string_view text) {
  return {std::move(path), text.size(), Crc32c(text.data(), text.size())};
}

std::string WriteHistory(const StoredHistory& history, std::size_t limit) {
  std::vector<Bytes> steps;
  steps.reserve(history.steps.size());
  for (const Step& step : history.steps) steps.push_back(Write(step));
  const Range range = FittingRange(steps, history.done, limit);
  Bytes bytes;
  Encoder out(bytes);
  out.Unsigned(history.texts.size());
  for (const KnownText& text : history.texts) {
    out.Text(text.path);
    out.Unsigned(text.size);
    out.Fixed32(text.checksum);
  }
  out.Unsigned(history.done - range.begin);
  out.Unsigned(range.end - range.begin);
  for (std::size_t i = range.begin; i < range.end; ++i) {
    bytes.insert(bytes.end(), steps[i].begin(), steps[i].end());
  }
  out.Fixed32(Crc32c(bytes.data(), bytes.size()));
  return kMagic + std::string(bytes.begin(), bytes.end());
}

std::optional<StoredHistory> ReadHistory(std::string_view bytes) {
  constexpr std::size_t kChecksum = 4;
  const std::string_view magic = kMagic;
  if (bytes.size() < magic.size() + kChecksum || bytes.substr(0, magic.size()) != magic) {
    return std::nullopt;
  }
  bytes.remove_prefix(magic.size());
  const auto* begin = reinterpret_cast<const std::uint8_t*>(bytes.data());
  const std::uint8_t* end = begin + bytes.size() - kChecksum;
  if (Decoder(end, end + kChecksum).Fixed32() != Crc32c(begin, bytes.size() - kChecksum)) {
    return std::nullopt;
  }
  Decoder in(begin, end);
  StoredHistory history;
  history.texts = ReadList<KnownText>(in, [](Decoder& d) {
    KnownText text;
    text.path = d.Text();
    text.size = d.Unsigned();
    text.checksum = d.Fixed32();
    return text;
  });
  history.done = in.Unsigned();
  history.steps = ReadList<Step>(in, ReadStep);
  if (!in.ok() || !in.at_end() || history.done > history.steps.size()) return std::nullopt;
  return history;
}

}  // namespace coppice::editor
