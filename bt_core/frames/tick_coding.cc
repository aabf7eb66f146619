#include "bt_core/frames/tick_coding.h"

#include <algorithm>
#include <chrono>

#include "bt_core/data/value_bytes.h"
#include "bt_core/engine/events/for_each_event.h"

namespace coppice {
namespace {

// The first byte of a tick: result, whether it is a part, and the step of its number.
constexpr std::uint8_t kResultBits = 7;
constexpr std::uint8_t kIsPart = 8;
constexpr int kStepShift = 4;
constexpr std::uint8_t kOtherStep = 2;  // written behind; 0 and 1 stand for themselves

constexpr unsigned kCodeBits = 3;
constexpr std::uint64_t kCodeMask = 7;

// Where a frame holds more than this, values are cut shorter.
constexpr std::size_t kMuch = 8 << 20;

std::uint64_t ZigZag(std::int64_t number) {
  return static_cast<std::uint64_t>(number) << 1 ^ (number < 0 ? ~std::uint64_t{0} : 0);
}
std::int64_t UnZigZag(std::uint64_t number) {
  return static_cast<std::int64_t>(number >> 1 ^ (number & 1 ? ~std::uint64_t{0} : 0));
}

// Nodes and slots are told from those before them in the tick.
struct Names {
  std::uint32_t node = 0;
  std::uint32_t slot = 0;
};

// Times of damaged bytes may be anything, so what is too large wraps around.
Duration Sum(Duration a, Duration b) {
  return Duration(static_cast<std::int64_t>(static_cast<std::uint64_t>(a.count()) +
                                            static_cast<std::uint64_t>(b.count())));
}
Duration Difference(Duration a, Duration b) {
  return Duration(static_cast<std::int64_t>(static_cast<std::uint64_t>(a.count()) -
                                            static_cast<std::uint64_t>(b.count())));
}

std::int64_t Step(std::uint32_t from, std::uint32_t to) {
  return std::int64_t{to} - std::int64_t{from};
}

bool NamesSlot(EventCode code) { return code == EventCode::kWrite || code == EventCode::kDelivery; }

// Into the beginning of a buffer, which grows as needed and never shrinks. `much`: where values are
// cut shorter.
class EventsEncoder {
 public:
  EventsEncoder(Bytes& buffer, std::size_t much)
      : buffer_(buffer), much_(much), at_(buffer.data()) {}

  /// Returns how many bytes they are.
  std::size_t EncodeAll(EventWords words) {
    ForEachRun(
        words,
        [this](const std::uint32_t* at, const std::uint32_t* end) { return PutStatuses(at, end); },
        [this](const Event& event) { PutOther(event); });
    return size();
  }

 private:
  static constexpr std::size_t kMostOfNumber = 10;  // bytes
  static constexpr auto kLastStatus = static_cast<std::uint32_t>(EventCode::kSkipped);

  std::size_t size() const { return static_cast<std::size_t>(at_ - buffer_.data()); }

  void MakeRoom(std::size_t room) {
    const std::size_t before = size();
    if (buffer_.size() >= before + room) return;
    buffer_.resize(2 * (before + room));
    at_ = buffer_.data() + before;
  }

  // In portions, so that there is room for each before it begins.
  const std::uint32_t* PutStatuses(const std::uint32_t* at, const std::uint32_t* end) {
    constexpr std::ptrdiff_t kPortion = 64;
    const std::uint32_t* stop = at;
    while (at == stop && at != end) {
      stop = at + std::min(kPortion, end - at);
      MakeRoom(kPortion * kMostOfNumber);
      std::uint8_t* out = at_;
      std::uint32_t node = names_.node;
      for (; at != stop; ++at) {
        const std::uint32_t word = *at;
        const std::uint32_t code = word & kCodeMask;
        if (code > kLastStatus) break;
        out = PutToken(out, node, word >> kCodeBits, code);
        node = word >> kCodeBits;
      }
      at_ = out;
      names_.node = node;
    }
    return at;
  }

  void PutOther(const Event& event) {
    const bool is_text = event.code == EventCode::kText;
    std::uint32_t& named = NamesSlot(event.code) ? names_.slot : names_.node;
    const std::size_t limit = size() > much_ ? kShortValueBytes : kMaxValueBytes;
    MakeRoom(4 * kMostOfNumber + std::min(event.bytes.size(), limit));
    at_ = PutToken(at_, named, event.index, static_cast<std::uint64_t>(event.code));
    named = event.index;
    if (is_text) at_ = PutUnsigned(at_, static_cast<std::uint64_t>(event.text));
    if (event.code == EventCode::kWrite) PutWriter(event.writer);
    if (event.bytes.size() <= limit) return PutBytes(event.bytes);
    PutBytes((is_text ? CutText : CutValue)(event.bytes, limit));
  }

  void PutWriter(NodeIndex writer) {
    const bool is_known = writer != kNoNode;
    at_ = PutUnsigned(at_, is_known ? ZigZag(Step(names_.node, writer)) + 1 : 0);
    if (is_known) names_.node = writer;
  }

  void PutBytes(std::string_view bytes) {
    at_ = PutUnsigned(at_, bytes.size());
    at_ = std::copy(bytes.begin(), bytes.end(), at_);
  }

  static std::uint8_t* PutToken(std::uint8_t* out, std::uint32_t before, std::uint32_t index,
                                std::uint64_t code) {
    return PutUnsigned(out, ZigZag(Step(before, index)) << kCodeBits | code);
  }

  // As Encoder::Unsigned.
  static std::uint8_t* PutUnsigned(std::uint8_t* out, std::uint64_t number) {
    for (; number >= 0x80; number >>= 7) *out++ = static_cast<std::uint8_t>(number | 0x80);
    *out++ = static_cast<std::uint8_t>(number);
    return out;
  }

  Bytes& buffer_;
  const std::size_t much_;
  std::uint8_t* at_;  // where the next byte goes
  Names names_;
};

class EventsDecoder {
 public:
  EventsDecoder(Decoder in, const TreeSize& size, EventWriter& out)
      : in_(in), size_(size), out_(out) {}

  bool DecodeAll() {
    while (in_.ok() && !in_.at_end()) {
      const std::uint64_t token = in_.Unsigned();
      if (!One(static_cast<EventCode>(token & kCodeMask), UnZigZag(token >> kCodeBits))) {
        return false;
      }
    }
    return in_.ok();
  }

 private:
  bool One(EventCode code, std::int64_t step) {
    const bool is_slot = NamesSlot(code);
    std::uint32_t& named = is_slot ? names_.slot : names_.node;
    if (!Move(named, step, is_slot ? size_.slots : size_.nodes)) return false;
    const std::uint32_t index = named;
    if (code <= EventCode::kSkipped) {
      out_.Status(NodeIndex(index), static_cast<Status>(code));
      return true;
    }
    std::uint32_t second = kNoNode;
    if (code == EventCode::kWrite && !Writer(second)) return false;
    if (code == EventCode::kText) second = in_.Index(kTextKinds);
    const std::string_view bytes = in_.View();
    if (in_.ok()) out_.Add(code, index, second, bytes);
    return in_.ok();
  }

  bool Writer(std::uint32_t& writer) {
    const std::uint64_t step = in_.Unsigned();
    if (step == 0) return true;
    if (!Move(names_.node, UnZigZag(step - 1), size_.nodes)) return false;
    writer = names_.node;
    return true;
  }

  static bool Move(std::uint32_t& index, std::int64_t step, std::size_t limit) {
    const std::uint64_t moved = index + static_cast<std::uint64_t>(step);
    if (moved >= limit) return false;
    index = static_cast<std::uint32_t>(moved);
    return true;
  }

  static constexpr std::size_t kTextKinds = 3;

  Decoder in_;
  const TreeSize& size_;
  EventWriter& out_;
  Names names_;
};

// The beginning of a text, at most so many bytes of it, no character cut into pieces.
std::string_view Beginning(std::string_view text, std::size_t size) {
  if (size >= text.size()) return text;
  std::size_t end = size;
  while (end > 0 && end + 4 > size && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
  return text.substr(0, end);
}

}  // namespace

std::string CutText(std::string_view text, std::size_t limit) {
  if (text.size() <= limit) return std::string(text);
  const std::string note = "... (cut: " + std::to_string(text.size()) + " bytes)";
  return std::string(Beginning(text, limit > note.size() ? limit - note.size() : 0)) + note;
}

std::string CutValue(std::string_view bytes, std::size_t limit) {
  if (bytes.size() <= limit) return std::string(bytes);
  return static_cast<char>(ValueForm::kText) + CutText(bytes.substr(1), limit - 1);
}

void TickEncoder::Restart(std::uint64_t tick, Time time) {
  place_ = {tick, time, Duration(0)};
  repetitions_ = 0;
  is_reusable_ = false;
}

void TickEncoder::Encode(const TickEvents& events, Bytes& out) {
  if (Repeats(events.words, out.size())) {
    ++repetitions_;
  } else {
    EncodeEvents(events.words, out.size());
  }
  const std::uint64_t number_step = events.tick - place_.tick;
  const Duration step = Difference(events.start.time_since_epoch(), place_.time.time_since_epoch());
  Encoder encoder(out);
  encoder.Byte(static_cast<std::uint8_t>(
      static_cast<unsigned>(events.result) | (events.is_whole ? 0u : kIsPart) |
      static_cast<unsigned>(number_step < kOtherStep ? number_step : kOtherStep) << kStepShift));
  if (number_step >= kOtherStep) encoder.Signed(static_cast<std::int64_t>(number_step));
  encoder.Signed(Difference(step, place_.step).count());
  // A clock that is set back while the tree ticks makes no ticks of less than no time.
  const Duration duration = std::max(events.duration, Duration(0));
  encoder.Unsigned(
      static_cast<std::uint64_t>(std::chrono::round<std::chrono::microseconds>(duration).count()));
  encoder.Unsigned(encoded_);
  out.insert(out.end(), events_.data(), events_.data() + encoded_);
  place_ = {events.tick, events.start, step};
}

bool TickEncoder::Repeats(EventWords words, std::size_t before) const {
  if (!is_reusable_ || before + encoded_ > kMuch) return false;
  return std::equal(words_.begin(), words_.end(), words.data, words.data + words.size);
}

void TickEncoder::EncodeEvents(EventWords words, std::size_t before) {
  repetitions_ = 0;
  encoded_ = EventsEncoder(events_, before < kMuch ? kMuch - before : 0).EncodeAll(words);
  is_reusable_ = before + encoded_ <= kMuch;
  words_.assign(words.data, words.data + words.size);
}

std::optional<TickEvents> TickDecoder::Decode(Decoder& in, const TreeSize& size) {
  const std::uint8_t head = in.Byte();
  const unsigned result = head & kResultBits;
  const unsigned step_code = head >> kStepShift;
  if (result > static_cast<unsigned>(Status::kSkipped) || step_code > kOtherStep) return {};
  const std::uint64_t number_step =
      step_code < kOtherStep ? step_code : static_cast<std::uint64_t>(in.Signed());
  const Duration step = Sum(place_.step, Duration(in.Signed()));
  const std::uint64_t duration = in.Unsigned();
  words_.Clear();
  const Decoder events = in.Part();
  if (!in.ok() || duration > kMaxMicroseconds) return {};
  if (!EventsDecoder(events, size, words_).DecodeAll()) return {};
  place_ = {place_.tick + number_step, Time(Sum(place_.time.time_since_epoch(), step)), step};
  return TickEvents{place_.tick,
                    place_.time,
                    std::chrono::microseconds(duration),
                    static_cast<Status>(result),
                    (head & kIsPart) == 0,
                    words_.words()};
}

}  // namespace coppice
