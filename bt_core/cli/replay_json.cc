// The JSON face of `coppice replay`. It only writes, and the engine's command line needs no JSON
// library, so it writes by hand.
#include <cstdio>

#include "bt_core/cli/replay_printer.h"

namespace coppice {
namespace {

// Length of the UTF-8 sequence at the start of a text, or 0 if there is none (RFC 3629).
std::size_t SequenceLength(std::string_view text) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
  };
  const auto continues = [&](std::size_t i) { return (byte(i) & 0xc0) == 0x80; };
  if (byte(0) < 0x80) return 1;
  if (byte(0) >= 0xc2 && byte(0) < 0xe0) return continues(1) ? 2 : 0;
  if (byte(0) >= 0xe0 && byte(0) < 0xf0) {
    const bool overlong = byte(0) == 0xe0 && byte(1) < 0xa0;
    const bool surrogate = byte(0) == 0xed && byte(1) >= 0xa0;
    return continues(1) && continues(2) && !overlong && !surrogate ? 3 : 0;
  }
  if (byte(0) >= 0xf0 && byte(0) < 0xf5) {
    const bool overlong = byte(0) == 0xf0 && byte(1) < 0x90;
    const bool too_large = byte(0) == 0xf4 && byte(1) >= 0x90;
    return continues(1) && continues(2) && continues(3) && !overlong && !too_large ? 4 : 0;
  }
  return 0;
}

void AppendCharacter(std::string& json, std::string_view character) {
  const char c = character[0];
  if (c == '"' || c == '\\') {
    json += '\\';
    json += c;
  } else if (c == '\n') {
    json += "\\n";
  } else if (character.size() == 1 && static_cast<unsigned char>(c) < 0x20) {
    char escape[8];
    std::snprintf(escape, sizeof(escape), "\\u%04x", static_cast<unsigned>(c));
    json += escape;
  } else {
    json += character;
  }
}

std::string Seconds(Time time) {
  char text[40];
  std::snprintf(text, sizeof(text), "%.9f", static_cast<double>(time.count()) * 1e-9);
  return text;
}

/// One object on one line.
class Object {
 public:
  Object& Add(std::string_view key, const std::string& json) {
    text_ += (text_.size() > 1 ? "," : "") + JsonText(key) + ":" + json;
    return *this;
  }
  Object& Add(std::string_view key, std::uint64_t number) {
    return Add(key, std::to_string(number));
  }
  Object& AddText(std::string_view key, std::string_view text) { return Add(key, JsonText(text)); }
  std::string Finish() const { return text_ + "}"; }

 private:
  std::string text_ = "{";
};

template <class List, class ToJson>
std::string Array(const List& list, ToJson to_json) {
  std::string json = "[";
  for (const auto& item : list) json += (json.size() > 1 ? "," : "") + to_json(item);
  return json + "]";
}

class JsonPrinter final : public ReplayPrinter {
 public:
  JsonPrinter(std::ostream& out, const RecordHeader& header) : out_(out), header_(header) {}

  void Header(const RecordHeader& header) override {
    Object metadata;
    for (const auto& [key, value] : header.metadata) metadata.AddText(key, value);
    Print(Object()
              .AddText("type", "header")
              .Add("version", header.version)
              .AddText("writer", header.writer)
              .AddText("tree", header.main_tree)
              .Add("start_ns", std::to_string(header.start.count()))
              .Add("metadata", metadata.Finish())
              .Add("files", Array(header.documents, [](const auto& d) { return JsonText(d.file); }))
              .Add("nodes", Array(header.nodes, [](const auto& n) { return JsonText(n.path); })));
  }

  void Entry(const RecordedTick& tick) override {
    const auto change = [this](const StatusChange& c) {
      return Object()
          .AddText("node", header_.nodes[c.node].path)
          .AddText("from", ToString(c.from))
          .AddText("to", ToString(c.to))
          .Finish();
    };
    const auto write = [this](const RecordedWrite& w) {
      const RecordedSlot& slot = header_.slots[w.slot];
      return Object()
          .AddText("scope", slot.scope)
          .AddText("key", slot.key)
          .Add("value", w.value ? JsonText(*w.value) : "null")
          .Finish();
    };
    const auto message = [this](const NodeMessage& m) {
      return Object().AddText("node", header_.nodes[m.node].path).AddText("text", m.text).Finish();
    };
    Print(Begin("tick", tick.time)
              .Add("tick", tick.tick)
              .AddText("result", ToString(tick.result))
              .Add("changes", Array(tick.changes, change))
              .Add("writes", Array(tick.writes, write))
              .Add("messages", Array(tick.messages, message)));
  }

  void Entry(const RecordedNote& note) override {
    Print(Begin("note", note.time).AddText("kind", note.kind).AddText("text", note.text));
  }

  void Entry(const RecordedGap& gap) override {
    Print(Begin("gap", gap.time)
              .Add("lost_ticks", gap.lost_ticks)
              .Add("first_tick", gap.first_tick)
              .Add("last_tick", gap.last_tick)
              .Add("lost_notes", gap.lost_notes));
  }

  void Entry(const RecordedEnd& end) override {
    Print(Begin("end", end.time).Add("ticks", end.ticks));
  }

  void Damage(const RecordDamage& damage) override {
    Print(Object()
              .AddText("type", "damage")
              .Add("offset", damage.offset)
              .AddText("what", damage.what));
  }

  void Summary(const ReplaySummary& summary) override {
    Object nodes;
    for (std::size_t i = 0; i < summary.nodes.size(); ++i) {
      const ReplaySummary::Node& node = summary.nodes[i];
      if (node.successes + node.failures == 0) continue;
      nodes.Add(header_.nodes[i].path,
                Object().Add("successes", node.successes).Add("failures", node.failures).Finish());
    }
    Print(Object()
              .AddText("type", "summary")
              .Add("ticks", summary.ticks)
              .Add("seconds", Seconds(summary.last - summary.first))
              .Add("changes", summary.changes)
              .Add("writes", summary.writes)
              .Add("notes", summary.notes)
              .Add("gaps", summary.gaps)
              .Add("lost_ticks", summary.lost_ticks)
              .Add("lost_notes", summary.lost_notes)
              .Add("damages", summary.damages)
              .Add("closed", summary.closed ? "true" : "false")
              .Add("nodes", nodes.Finish()));
  }

 private:
  Object Begin(std::string_view type, Time time) const {
    Object object;
    object.AddText("type", type).Add("time", Seconds(time - header_.start));
    return object;
  }
  void Print(const Object& object) { out_ << object.Finish() << "\n"; }

  std::ostream& out_;
  const RecordHeader& header_;
};

}  // namespace

std::string JsonText(std::string_view text) {
  std::string json = "\"";
  while (!text.empty()) {
    const std::size_t length = SequenceLength(text);
    AppendCharacter(json, length > 0 ? text.substr(0, length) : "\xEF\xBF\xBD");
    text.remove_prefix(length > 0 ? length : 1);
  }
  return json + "\"";
}

std::unique_ptr<ReplayPrinter> MakeJsonPrinter(std::ostream& out, const RecordHeader& header) {
  return std::make_unique<JsonPrinter>(out, header);
}

}  // namespace coppice
