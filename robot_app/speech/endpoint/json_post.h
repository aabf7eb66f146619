// How services of others are asked. Included by .cc files of this folder only.
#ifndef COPPICE_ROBOT_APP_SPEECH_ENDPOINT_JSON_POST_H_
#define COPPICE_ROBOT_APP_SPEECH_ENDPOINT_JSON_POST_H_

#include <cstddef>
#include <string>

#include "bt_core/base/json.h"
#include "robot_app/common/web/curl_handle.h"
#include "robot_app/speech/endpoint/speech_service.h"

namespace coppice::robot::speech {

CurlHandle HandleOf(const SpeechService& service, const char* path);
/// The body is sent; it must outlive the transfer.
void SetJson(CurlHandle& curl, const std::string& body);
/// The body of the answer, with the key of the service in the header of its interface.
Expected<std::string> ReplyTo(CurlHandle& curl, const SpeechService& service, std::size_t most);

/// JSON to JSON.
Expected<JsonValue> PostJson(const SpeechService& service, const char* path,
                             const std::string& body);

}  // namespace coppice::robot::speech

#endif  // COPPICE_ROBOT_APP_SPEECH_ENDPOINT_JSON_POST_H_
