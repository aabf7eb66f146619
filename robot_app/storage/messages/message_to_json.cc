#include "robot_app/storage/messages/message_to_json.h"

#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>

#include "bt_core/base/json.h"
#include "bt_core/model/utf8.h"
#include "robot_app/common/web/base64.h"

namespace coppice::robot::storage {
namespace {

using Count = MessageField::Count;

struct TooFewBytes {};
struct TooLong {};

bool IsPlain(std::string_view text) {
  for (const char c : text) {
    if (c < ' ' || c > '~' || c == '"' || c == '\\') return false;
  }
  return true;
}

class Writer {
 public:
  Writer(const MessageLayout& layout, std::string_view bytes, const JsonRules& rules)
      : layout_(layout), rest_(bytes), rules_(rules) {}

  std::string Write() {
    WriteMessage(layout_.messages[0]);
    return std::move(json_);
  }

  std::size_t bytes_left() const { return rest_.size(); }

 private:
  std::string_view Take(std::uint64_t size) {
    if (size > rest_.size()) throw TooFewBytes();
    const std::string_view bytes = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return bytes;
  }

  template <class Value>
  Value Take() {
    Value value;
    std::memcpy(&value, Take(sizeof(Value)).data(), sizeof(Value));
    return value;
  }

  std::string_view TakeAll(std::uint64_t size, std::uint32_t length) {
    if (size != 0 && length > rest_.size() / size) throw TooFewBytes();
    return Take(size * length);
  }

  void WriteMessage(const MessageLayout::Message& message) {
    json_ += '{';
    for (std::uint32_t i = message.first; i < message.end; ++i) {
      const MessageField& field = layout_.fields[i];
      json_ += i == message.first ? "\"" : ",\"";
      json_ += field.name;
      json_ += "\":";
      WriteField(field);
    }
    json_ += '}';
    if (json_.size() > rules_.longest_json) throw TooLong();
  }

  void WriteField(const MessageField& field) {
    if (field.count == Count::kOne) return WriteOne(field);
    const auto length = field.count == Count::kFixed ? field.length : Take<std::uint32_t>();
    if (length > rules_.longest_array) return LeaveOut(field, length);
    if (field.kind == FieldKind::kUint8) return AddQuoted(ToBase64(Take(length)));
    json_ += '[';
    for (std::uint32_t i = 0; i < length; ++i) {
      if (i > 0) json_ += ',';
      WriteOne(field);
    }
    json_ += ']';
  }

  void WriteOne(const MessageField& field) {
    switch (field.kind) {
      case FieldKind::kBool:
        json_ += Take<std::uint8_t>() != 0 ? "true" : "false";
        break;
      case FieldKind::kInt8:
        return Add(static_cast<int>(Take<std::int8_t>()));
      case FieldKind::kUint8:
        return Add(static_cast<int>(Take<std::uint8_t>()));
      case FieldKind::kInt16:
        return Add(Take<std::int16_t>());
      case FieldKind::kUint16:
        return Add(Take<std::uint16_t>());
      case FieldKind::kInt32:
        return Add(Take<std::int32_t>());
      case FieldKind::kUint32:
        return Add(Take<std::uint32_t>());
      case FieldKind::kInt64:
        return Add(Take<std::int64_t>());
      case FieldKind::kUint64:
        return Add(Take<std::uint64_t>());
      case FieldKind::kFloat32:
        return AddReal(Take<float>());
      case FieldKind::kFloat64:
        return AddReal(Take<double>());
      case FieldKind::kTime:
        return WriteTime<std::uint32_t>();
      case FieldKind::kDuration:
        return WriteTime<std::int32_t>();
      case FieldKind::kString:
        return AddText(Take(Take<std::uint32_t>()));
      case FieldKind::kMessage:
        return WriteMessage(layout_.messages[field.message]);
    }
  }

  template <class Number>
  void Add(Number number) {
    char text[32];
    json_.append(text, std::to_chars(text, text + sizeof(text), number).ptr);
  }

  template <class Real>
  void AddReal(Real number) {
    if (std::isfinite(number)) return Add(number);
    AddQuoted(std::isnan(number) ? "NaN" : number > 0 ? "Infinity" : "-Infinity");
  }

  template <class Number>
  void WriteTime() {
    json_ += "{\"secs\":";
    Add(Take<Number>());
    json_ += ",\"nsecs\":";
    Add(Take<Number>());
    json_ += '}';
  }

  void AddQuoted(std::string_view plain) {
    json_ += '"';
    json_ += plain;
    json_ += '"';
  }

  void AddText(std::string_view text) {
    if (text.size() > rules_.longest_json) throw TooLong();
    if (IsPlain(text)) return AddQuoted(text);
    const bool is_text =
        FindInvalidUtf8(text) == text.size() && text.find('\0') == std::string_view::npos;
    json_ += is_text ? JsonString(text) : "{\"base64\":\"" + ToBase64(text) + "\"}";
  }

  void LeaveOut(const MessageField& field, std::uint32_t length) {
    json_ += "{\"left_out\":\"";
    if (field.kind == FieldKind::kMessage) {
      json_ += layout_.messages[field.message].type;
    } else {
      json_ += Word(field.kind);
    }
    json_ += "\",\"length\":";
    Add(length);
    const std::optional<std::uint64_t> size = layout_.SizeOfOne(field);
    if (size) {
      TellWhere(TakeAll(*size, length));
    } else {
      Pass(field, length);
    }
    json_ += '}';
  }

  void TellWhere(std::string_view bytes) {
    const std::string file = rules_.keep ? rules_.keep(bytes) : "";
    if (!file.empty()) json_ += ",\"file\":" + JsonString(file);
  }

  // Elements whose size is not fixed hold a length, at least: there are no more of them than bytes.
  void Pass(const MessageField& field, std::uint32_t length) {
    for (std::uint32_t i = 0; i < length; ++i) PassOne(field);
  }

  void PassOne(const MessageField& field) {
    if (field.kind == FieldKind::kString) return (void)Take(Take<std::uint32_t>());
    if (field.kind != FieldKind::kMessage) return (void)Take(SizeOf(field.kind));
    const MessageLayout::Message& message = layout_.messages[field.message];
    if (message.size) return (void)Take(*message.size);
    for (std::uint32_t i = message.first; i < message.end; ++i) PassField(layout_.fields[i]);
  }

  void PassField(const MessageField& field) {
    const auto length = field.count == Count::kAny ? Take<std::uint32_t>() : field.length;
    const std::optional<std::uint64_t> size = layout_.SizeOfOne(field);
    if (!size) return Pass(field, length);
    TakeAll(*size, length);
  }

  const MessageLayout& layout_;
  std::string_view rest_;
  const JsonRules& rules_;
  std::string json_;
};

}  // namespace

Expected<std::string> MessageToJson(const MessageLayout& layout, std::string_view bytes,
                                    const JsonRules& rules) {
  Writer writer(layout, bytes, rules);
  const std::string& type = layout.messages[0].type;
  try {
    std::string json = writer.Write();
    if (writer.bytes_left() == 0) return json;
    return Problem{"a message of " + type + " has " + std::to_string(writer.bytes_left()) +
                   " bytes too many"};
  } catch (const TooFewBytes&) {
    return Problem{"a message of " + type + " has too few bytes"};
  } catch (const TooLong&) {
    return Problem{"a message of " + type + " is too long"};
  }
}

}  // namespace coppice::robot::storage
