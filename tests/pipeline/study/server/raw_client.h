#pragma once

#include <string>

namespace mien::pipeline {

/// A connection to a server on this machine that sends arbitrary bytes.
class RawClient {
 public:
  explicit RawClient(int port);
  ~RawClient();
  RawClient(const RawClient&) = delete;
  RawClient& operator=(const RawClient&) = delete;

  /// False when the other side is gone.
  bool send(const std::string& bytes);

  /// What comes until the other side closes, or nothing more within that time.
  std::string receive(double seconds = 5);

  /// One answer, by its Content-Length.
  std::string receive_answer();

 private:
  bool receive_some(double seconds);

  int socket_;
  std::string received_;
};

/// What the server answers to these bytes until it closes.
std::string reply_of(int port, const std::string& bytes);

/// A port of this machine that was free a moment ago.
int free_port();

/// "GET /x HTTP/1.1" with what has to be there, and the connection to be closed.
std::string get_request(const std::string& target, const std::string& headers = "");
std::string post_request(const std::string& target, const std::string& body,
                         const std::string& headers = "Content-Type: application/json\r\n");

/// 200 of "HTTP/1.1 200 OK…"; 0 of anything else.
int status_in(const std::string& answer);
std::string body_in(const std::string& answer);
std::string header_in(const std::string& answer, const std::string& name);

}  // namespace mien::pipeline
