#include "robot_app/storage/messages/json_to_message.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "bt_core/base/json_library.h"
#include "robot_app/common/web/base64.h"

namespace coppice::robot::storage {
namespace {

using Count = MessageField::Count;
using nlohmann::json;

constexpr std::uint64_t kLongestMessage = std::uint64_t{64}
                                          << 20;  // bytes, with zeros for what is not there

class Builder {
 public:
  Builder(const MessageLayout& layout, const ReadKept& read) : layout_(layout), read_(read) {}

  MessageBytes Build(const json& value) {
    AddMessage(layout_.messages[0], value);
    return std::move(message_);
  }

 private:
  // The members in the order of the fields, each of which is named if it does not fit.
  void AddMessage(const MessageLayout::Message& message, const json& value) {
    for (std::uint32_t i = message.first; i < message.end; ++i) {
      const MessageField& field = layout_.fields[i];
      try {
        AddField(field, value.at(field.name));
      } catch (const json::exception&) {
        throw std::runtime_error("\"" + field.name + "\" does not fit " + message.type);
      }
    }
  }

  void AddField(const MessageField& field, const json& value) {
    if (field.count == Count::kOne) return AddOne(field, value);
    if (value.is_object()) return AddLeftOut(field, value);
    if (field.kind == FieldKind::kUint8) {
      const std::string bytes = BytesOf(value);
      AddLength(field, bytes.size());
      message_.bytes += bytes;
      return;
    }
    const auto& elements = value.get_ref<const json::array_t&>();
    AddLength(field, elements.size());
    for (const json& element : elements) AddOne(field, element);
  }

  void AddLength(const MessageField& field, std::size_t length) {
    if (field.count == Count::kAny) return Add(static_cast<std::uint32_t>(length));
    if (length != field.length)
      throw std::runtime_error("\"" + field.name + "\" has a wrong length");
  }

  void AddLeftOut(const MessageField& field, const json& value) {
    const auto length = value.at("length").get<std::uint32_t>();
    const std::uint64_t size = layout_.SizeOfOne(field).value_or(0);
    const auto kept = value.contains("file") ? read_(value.at("file")) : std::nullopt;
    if (size != 0 && kept && kept->size() / size == length && kept->size() % size == 0) {
      AddLength(field, length);
      message_.bytes += *kept;
      return;
    }
    message_.is_whole = false;
    if (field.count == Count::kAny) return Add(std::uint32_t{0});
    AddZeros(size, field.length);
  }

  // A server may say anything of what it does not have.
  void AddZeros(std::uint64_t size, std::uint64_t length) {
    const std::uint64_t room = kLongestMessage - std::min(kLongestMessage, message_.bytes.size());
    if (size != 0 && length > room / size) throw std::runtime_error("the message is too long");
    message_.bytes.append(size * length, '\0');
  }

  void AddOne(const MessageField& field, const json& value) {
    switch (field.kind) {
      case FieldKind::kBool:
        return Add<std::uint8_t>(value.get<bool>() ? 1 : 0);
      case FieldKind::kInt8:
        return Add(value.get<std::int8_t>());
      case FieldKind::kUint8:
        return Add(value.get<std::uint8_t>());
      case FieldKind::kInt16:
        return Add(value.get<std::int16_t>());
      case FieldKind::kUint16:
        return Add(value.get<std::uint16_t>());
      case FieldKind::kInt32:
        return Add(value.get<std::int32_t>());
      case FieldKind::kUint32:
        return Add(value.get<std::uint32_t>());
      case FieldKind::kInt64:
        return Add(value.get<std::int64_t>());
      case FieldKind::kUint64:
        return Add(value.get<std::uint64_t>());
      case FieldKind::kFloat32:
        return Add(static_cast<float>(RealOf(value)));
      case FieldKind::kFloat64:
        return Add(RealOf(value));
      case FieldKind::kTime:
        return AddTime<std::uint32_t>(value);
      case FieldKind::kDuration:
        return AddTime<std::int32_t>(value);
      case FieldKind::kString:
        return AddText(value.is_object() ? BytesOf(value.at("base64")) : value.get<std::string>());
      case FieldKind::kMessage:
        return AddMessage(layout_.messages[field.message], value);
    }
  }

  template <class Value>
  void Add(Value value) {
    char bytes[sizeof(Value)];
    std::memcpy(bytes, &value, sizeof(Value));
    message_.bytes.append(bytes, sizeof(Value));
  }

  template <class Number>
  void AddTime(const json& value) {
    Add(value.at("secs").get<Number>());
    Add(value.at("nsecs").get<Number>());
  }

  void AddText(const std::string& text) {
    Add(static_cast<std::uint32_t>(text.size()));
    message_.bytes += text;
  }

  static double RealOf(const json& value) {
    if (!value.is_string()) return value.get<double>();
    const auto& word = value.get_ref<const std::string&>();
    if (word == "Infinity") return std::numeric_limits<double>::infinity();
    if (word == "-Infinity") return -std::numeric_limits<double>::infinity();
    if (word == "NaN") return std::nan("");
    throw std::runtime_error("\"" + word + "\" is no number");
  }

  static std::string BytesOf(const json& value) {
    const std::optional<std::string> bytes = FromBase64(value.get_ref<const std::string&>());
    if (!bytes) throw std::runtime_error("expected base64");
    return *bytes;
  }

  const MessageLayout& layout_;
  const ReadKept& read_;
  MessageBytes message_;
};

}  // namespace

Expected<MessageBytes> JsonToMessage(const MessageLayout& layout, std::string_view text,
                                     const ReadKept& read) {
  try {
    return Builder(layout, read).Build(ParseLimitedJson(text, kMostOwnJsonValues));
  } catch (const std::exception& error) {
    return Problem{layout.messages[0].type + ": " + error.what()};
  }
}

}  // namespace coppice::robot::storage
