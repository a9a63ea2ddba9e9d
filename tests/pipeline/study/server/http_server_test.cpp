#include "pipeline/study/server/http_server.h"

#include <atomic>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "pipeline/study/server/raw_client.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

using test::TemporaryFolder;

/// Tells what it was asked.
HttpResponse echo(const HttpRequest& request) {
  std::string text = request.method;
  for (const std::string& part : request.path) text += " " + part;
  return {.body = text + " " + request.body};
}

HttpSettings quick_settings() {
  HttpSettings settings;
  settings.limits.head = std::chrono::milliseconds(400);
  settings.limits.body = std::chrono::milliseconds(400);
  settings.limits.idle = std::chrono::milliseconds(1500);
  settings.connections = 8;
  return settings;
}

TEST(HttpServer, AnswersWhatItIsAsked) {
  const HttpServer server(HttpSettings{}, echo);
  EXPECT_EQ(body_in(reply_of(server.port(), get_request("/a/b-1.x/?q=2"))), "GET a b-1.x  ");
  EXPECT_EQ(body_in(reply_of(server.port(), post_request("/a", "given"))), "POST a given");
}

TEST(HttpServer, AnswersSeveralRequestsOverOneConnectionEachWithItsOwnBody) {
  const HttpServer server(HttpSettings{}, echo);
  RawClient client(server.port());
  client.send(
      "POST /one HTTP/1.1\r\nHost: here\r\nContent-Length: 3\r\n\r\nabcPOST /two HTTP/1.1\r\nHost: "
      "here\r\n");
  EXPECT_EQ(body_in(client.receive_answer()), "POST one abc");
  client.send(
      "Content-Length: 2\r\n\r\nxyGET /three HTTP/1.1\r\nHost: here\r\nConnection: close\r\n\r\n");
  EXPECT_EQ(body_in(client.receive_answer()), "POST two xy");
  EXPECT_EQ(body_in(client.receive()), "GET three ");
}

TEST(HttpServer, GuardsEveryAnswer) {
  const HttpServer server(quick_settings(), echo);
  for (const std::string& request :
       {get_request("/a"), get_request("/../a"), std::string("nonsense\r\n\r\n"),
        post_request("/a", std::string(70'000, 'x'))}) {
    const std::string answer = reply_of(server.port(), request);
    EXPECT_NE(header_in(answer, "Content-Security-Policy").find("default-src 'none'"),
              std::string::npos)
        << answer;
    EXPECT_EQ(header_in(answer, "Content-Security-Policy").find("unsafe"), std::string::npos);
    EXPECT_EQ(header_in(answer, "X-Content-Type-Options"), "nosniff");
    EXPECT_EQ(header_in(answer, "Referrer-Policy"), "no-referrer");
    EXPECT_EQ(header_in(answer, "Cache-Control"), "no-store");
  }
}

TEST(HttpServer, LetsPagesCompileOnlyWhereItIsAsked) {
  const HttpServer server(quick_settings(), [](const HttpRequest& request) {
    HttpResponse answer = echo(request);
    answer.webassembly = request.path.front() == "a";
    return answer;
  });
  const std::string policy =
      header_in(reply_of(server.port(), get_request("/a")), "Content-Security-Policy");
  EXPECT_NE(policy.find("script-src 'self' 'wasm-unsafe-eval';"), std::string::npos) << policy;
  EXPECT_EQ(policy.find("'unsafe-eval'"), std::string::npos) << policy;
  const std::string other =
      header_in(reply_of(server.port(), get_request("/b")), "Content-Security-Policy");
  EXPECT_EQ(other.find("unsafe"), std::string::npos) << other;
}

TEST(HttpServer, LetsOnlyPlainPathsThrough) {
  std::atomic<int> asked = 0;
  const HttpServer server(quick_settings(), [&](const HttpRequest& request) {
    ++asked;
    return echo(request);
  });
  for (const char* target : {"/../../etc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "/a/..%2f..%2fetc",
                             "/a//b", "/.git", "/a/./b", "/a%00b", "/a\\..\\b", "/%252e%252e/",
                             "/a;b", "/~root", "/a+b", "/%c0%ae%c0%ae/"}) {
    EXPECT_EQ(status_in(reply_of(server.port(), get_request(target))), 404) << target;
  }
  EXPECT_EQ(asked, 0);
}

TEST(HttpServer, RefusesWhatIsNoRequest) {
  const HttpServer server(quick_settings(), echo);
  const auto status = [&](const std::string& bytes) {
    return status_in(reply_of(server.port(), bytes));
  };
  EXPECT_EQ(status("GET / HTTP/2.0\r\n\r\n"), 400);
  EXPECT_EQ(status("GET http://elsewhere/ HTTP/1.1\r\nHost: here\r\n\r\n"), 400);
  EXPECT_EQ(status("GET /\n\n\r\n\r\n"), 400);
  EXPECT_EQ(status("GET / HTTP/1.1\r\nHost: here\r\nA : b\r\n\r\n"), 400);
  EXPECT_EQ(status("GET / HTTP/1.1\r\nHost: here\r\nA: b\r\n c\r\n\r\n"), 400);
  EXPECT_EQ(status(std::string("GET / HTTP/1.1\r\nHost: here\r\nA: b\0\r\n\r\n", 37)), 400);
  EXPECT_EQ(
      status("POST / HTTP/1.1\r\nHost: here\r\nContent-Length: 1\r\nContent-Length: 2\r\n\r\nab"),
      400);
  EXPECT_EQ(status("POST / HTTP/1.1\r\nHost: here\r\nContent-Length: +1\r\n\r\na"), 400);
  EXPECT_EQ(status("POST / HTTP/1.1\r\nHost: here\r\nContent-Length: 99999999999999999999\r\n\r\n"),
            413);
  EXPECT_EQ(status("POST / HTTP/1.1\r\nHost: here\r\nTransfer-Encoding: "
                   "chunked\r\n\r\n5\r\nabcde\r\n0\r\n\r\n"),
            411);
  EXPECT_EQ(status("POST / HTTP/1.1\r\nHost: here\r\n\r\n"), 411);
  EXPECT_EQ(status(post_request("/", "a", "Content-Encoding: gzip\r\n")), 415);
}

TEST(HttpServer, RefusesABodyWhoseEndOthersMightSeeElsewhere) {
  const HttpServer server(quick_settings(), echo);
  const auto status = [&](const std::string& lines) {
    return status_in(
        reply_of(server.port(), "POST / HTTP/1.1\r\nHost: here\r\n" + lines + "\r\nabc"));
  };
  EXPECT_EQ(status("Content-Length: 3\r\nConnection: close\r\n"), 200);
  EXPECT_EQ(status("Content-Length: 3\r\nContent-Length: 3\r\n"), 400);
  EXPECT_EQ(status("Content-Length: 3, 3\r\n"), 400);
  EXPECT_EQ(status("Content-Length: 3x\r\n"), 400);
  EXPECT_EQ(status("Content-Length: 99999999999999999999x\r\n"), 400);
  EXPECT_EQ(status("Content-Length: 0x3\r\n"), 400);
  EXPECT_EQ(status("Content-Length:\r\n 3\r\n"), 400);
  EXPECT_EQ(status("Content-Length: 3\r\nTransfer-Encoding: chunked\r\n"), 411);
  EXPECT_EQ(status("Transfer-Encoding: chunked\r\nContent-Length: 3\r\n"), 411);
  EXPECT_EQ(status("Transfer-Encoding: identity\r\nContent-Length: 3\r\n"), 411);
}

TEST(HttpServer, AsksForABodyThatAwaitsIt) {
  const HttpServer server(quick_settings(), echo);
  RawClient client(server.port());
  client.send(
      "POST /a HTTP/1.1\r\nHost: here\r\nContent-Length: 3\r\nExpect: 100-continue\r\n\r\n");
  EXPECT_EQ(status_in(client.receive_answer()), 100);
  client.send("abc");
  EXPECT_EQ(body_in(client.receive_answer()), "POST a abc");
  RawClient greedy(server.port());
  greedy.send(
      "POST /a HTTP/1.1\r\nHost: here\r\nContent-Length: 70000\r\n"
      "Expect: 100-continue\r\n\r\n");
  EXPECT_EQ(status_in(greedy.receive_answer()), 413);
}

TEST(HttpServer, RefusesARequestThatDoesNotSayWhomItIsFor) {
  const HttpServer server(quick_settings(), echo);
  for (const char* request :
       {"GET /a HTTP/1.1\r\n\r\n", "GET /a HTTP/1.0\r\n\r\n", "GET /a HTTP/1.1\r\nHost:\r\n\r\n",
        "GET /a HTTP/1.1\r\nHost: one\r\nHost: other\r\n\r\n",
        "POST /a HTTP/1.1\r\nContent-Length: 1\r\n\r\na"})
    EXPECT_EQ(status_in(reply_of(server.port(), request)), 400) << request;
  const std::string answer = reply_of(server.port(), "GET /a HTTP/1.1\r\n\r\n");
  EXPECT_NE(body_in(answer).find("has no Host header"), std::string::npos) << answer;
  EXPECT_EQ(status_in(reply_of(server.port(), "GET /a HTTP/1.0\r\nHost: here\r\n\r\n")), 200);
}

TEST(HttpServer, RefusesTooMuch) {
  const HttpServer server(quick_settings(), echo);
  std::string flood = "GET / HTTP/1.1\r\nHost: here\r\n";
  for (int line = 0; line < 200; ++line) flood += "A" + std::to_string(line) + ": b\r\n";
  EXPECT_EQ(status_in(reply_of(server.port(), flood + "\r\n")), 431);
  EXPECT_EQ(status_in(reply_of(server.port(),
                               "GET / HTTP/1.1\r\nHost: here\r\nA: " + std::string(20'000, 'b'))),
            431);
  EXPECT_EQ(status_in(reply_of(server.port(), get_request("/" + std::string(17'000, 'a')))), 431);
  EXPECT_EQ(status_in(reply_of(server.port(), post_request("/a", std::string(65'537, 'a')))), 413);
  EXPECT_EQ(status_in(reply_of(server.port(), post_request("/a", std::string(65'536, 'a')))), 200);
}

TEST(HttpServer, WaitsForNoSlowClient) {
  const HttpServer server(quick_settings(), echo);
  RawClient head(server.port());
  RawClient body(server.port());
  head.send("GET / HT");
  body.send("POST / HTTP/1.1\r\nHost: here\r\nContent-Length: 50\r\n\r\n");
  for (int count = 0; count < 8; ++count) {  // a byte now and then does not help
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    head.send("A");
    body.send("A");
  }
  EXPECT_EQ(status_in(head.receive()), 408);
  EXPECT_EQ(status_in(body.receive()), 408);
}

TEST(HttpServer, WaitsForNoClientThatDoesNotReadItsAnswer) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "film");
  std::filesystem::resize_file(folder.path() / "film", std::uintmax_t{64} << 20U);
  HttpSettings settings = quick_settings();
  settings.limits.answer = std::chrono::milliseconds(400);
  settings.connections = 1;
  const HttpServer server(settings, [&](const HttpRequest& request) {
    return http_file(request, folder.path() / "film", "video/mp4");
  });
  RawClient client(server.port());
  client.send("GET /film HTTP/1.1\r\nHost: here\r\n\r\n");
  int status = 0;
  for (int attempt = 0; attempt < 200 && status != 206; ++attempt) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    status = status_in(reply_of(server.port(), get_request("/film", "Range: bytes=0-9\r\n")));
  }
  EXPECT_EQ(status, 206);
}

TEST(HttpServer, RefusesMoreConnectionsThanItHasRoomForAndRecovers) {
  HttpSettings settings = quick_settings();
  settings.connections = 2;
  const HttpServer server(settings, echo);
  {
    RawClient first(server.port());
    RawClient second(server.port());
    first.send("GET /a HTTP/1.1\r\nHost: here\r\n\r\n");
    second.send("GET /a HTTP/1.1\r\nHost: here\r\n\r\n");
    first.receive_answer();
    second.receive_answer();
    EXPECT_EQ(status_in(reply_of(server.port(), get_request("/a"))), 503);
  }
  int status = 0;
  for (int attempt = 0; attempt < 50 && status != 200; ++attempt) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    status = status_in(reply_of(server.port(), get_request("/a")));
  }
  EXPECT_EQ(status, 200);
}

TEST(HttpServer, LimitsHowOftenAnAddressAsks) {
  HttpSettings settings = quick_settings();
  settings.requests = {.burst = 3, .per_second = 0.001};
  const HttpServer server(settings, echo);
  for (int count = 0; count < 3; ++count)
    EXPECT_EQ(status_in(reply_of(server.port(), get_request("/a"))), 200);
  EXPECT_EQ(status_in(reply_of(server.port(), get_request("/a"))), 429);
}

/// Tells where the client is, and by which protocol it came.
HttpResponse where_from(const HttpRequest& request) {
  return {.body = request.address + " " + header_of(request, "x-forwarded-for") + " " +
                  header_of(request, "x-forwarded-proto")};
}

TEST(HttpServer, BelievesAProxyOnlyWhereThereIsOne) {
  const std::string request =
      get_request("/a", "X-Forwarded-For: 203.0.113.9\r\nX-Forwarded-Proto: https\r\n");
  const HttpServer alone(HttpSettings{}, where_from);
  EXPECT_EQ(body_in(reply_of(alone.port(), request)), "127.0.0.1  ");
  const HttpServer behind({.behind_proxy = true}, where_from);
  EXPECT_EQ(body_in(reply_of(behind.port(), request)), "203.0.113.9 203.0.113.9 https");
  EXPECT_EQ(body_in(reply_of(behind.port(), get_request("/a"))), "127.0.0.1  ");
}

TEST(HttpServer, TakesTheAddressThatTheNearestProxyHasAdded) {
  const auto address = [](const std::string& header) {
    HttpRequest request;
    request.headers["x-forwarded-for"] = header;
    return forwarded_address(request, "127.0.0.1");
  };
  EXPECT_EQ(address("198.51.100.7, 203.0.113.9"), "203.0.113.9");
  EXPECT_EQ(address("2001:DB8:0:0::1"), "2001:db8::1") << "one address has one text";
  for (const char* none : {"", "unknown", "203.0.113.9, ", "1.2.3.4:80", "203.0.113.300"})
    EXPECT_EQ(address(none), "127.0.0.1") << none;
}

TEST(HttpServer, LimitsClientsBehindAProxyOneByOne) {
  const HttpServer server({.behind_proxy = true, .requests = {.burst = 2, .per_second = 0.001}},
                          where_from);
  const auto status = [&](const char* address) {
    const std::string header = std::string("X-Forwarded-For: ") + address + "\r\n";
    return status_in(reply_of(server.port(), get_request("/a", header)));
  };
  EXPECT_EQ(status("203.0.113.1"), 200);
  EXPECT_EQ(status("203.0.113.1"), 200);
  EXPECT_EQ(status("203.0.113.1"), 429);
  EXPECT_EQ(status("203.0.113.2"), 200);
}

TEST(HttpServer, SendsTheRangesOfAFileThatAreAskedFor) {
  const TemporaryFolder folder;
  std::string bytes;
  for (int count = 0; count < 200'000; ++count) bytes += static_cast<char>('a' + count % 23);
  std::ofstream(folder.path() / "film") << bytes;
  std::ofstream(folder.path() / "empty");
  const HttpServer server(HttpSettings{}, [&](const HttpRequest& request) {
    return http_file(request, folder.path() / request.path.at(0), "video/mp4");
  });
  const auto answer = [&](const std::string& range) {
    return reply_of(server.port(), get_request("/film", "Range: " + range + "\r\n"));
  };
  EXPECT_EQ(body_in(reply_of(server.port(), get_request("/film"))), bytes);
  EXPECT_EQ(body_in(answer("bytes=5-9")), bytes.substr(5, 5));
  EXPECT_EQ(header_in(answer("bytes=5-9"), "Content-Range"), "bytes 5-9/200000");
  EXPECT_EQ(status_in(answer("bytes=5-9")), 206);
  EXPECT_EQ(body_in(answer("bytes=70000-")), bytes.substr(70'000));
  EXPECT_EQ(body_in(answer("bytes=-7")), bytes.substr(bytes.size() - 7));
  EXPECT_EQ(body_in(answer("bytes=0-99999999999")), bytes);
  EXPECT_EQ(status_in(answer("bytes=200000-")), 416);
  EXPECT_EQ(status_in(answer("bytes=-0")), 416);
  for (const char* abuse : {"bytes=0-,0-,0-,0-,0-,0-", "bytes=9-5", "bytes=x-y", "lines=1-2",
                            "bytes=0-99999999999999999999999", "bytes=--5", "bytes="}) {
    EXPECT_EQ(status_in(answer(abuse)), 200) << abuse;
  }
  EXPECT_EQ(status_in(reply_of(server.port(), get_request("/empty"))), 200);
  EXPECT_EQ(status_in(reply_of(server.port(), get_request("/none"))), 404);
  const std::string head =
      reply_of(server.port(), "HEAD /film HTTP/1.1\r\nHost: here\r\nConnection: close\r\n\r\n");
  EXPECT_EQ(header_in(head, "Content-Length"), "200000");
  EXPECT_EQ(body_in(head), "");
}

TEST(HttpServer, TellsAClientNothingOfAFailure) {
  std::string told;
  const HttpServer server(
      HttpSettings{},
      [](const HttpRequest&) -> HttpResponse { throw std::runtime_error("/a/secret/place"); },
      [&](const std::string& failure) { told = failure; });
  const std::string answer = reply_of(server.port(), get_request("/a"));
  EXPECT_EQ(status_in(answer), 500);
  EXPECT_EQ(answer.find("secret"), std::string::npos);
  EXPECT_EQ(told, "/a/secret/place");
}

/// Why nothing is listened at.
std::string refusal_to_listen(const HttpSettings& settings) {
  try {
    const HttpServer server(settings, echo);
  } catch (const Error& error) {
    const std::string words = error.what(), begin = "cannot listen on this address: ";
    const std::size_t from = words.find(begin) + begin.size();
    return words.substr(from, words.find(';', from) - from);
  }
  return {};
}

TEST(HttpServer, RefusesAPortThatIsTaken) {
  const HttpServer server(HttpSettings{}, echo);
  HttpSettings same;
  same.port = server.port();
  EXPECT_EQ(refusal_to_listen(same), "Address already in use");
}

TEST(HttpServer, RefusesAnAddressThatIsNotHere) {
  EXPECT_EQ(refusal_to_listen({.listen = "192.0.2.1"}), "Cannot assign requested address");
  EXPECT_EQ(refusal_to_listen({.listen = "not.an.address.invalid"}), "no such address here");
}

TEST(HttpServer, EndsWhileClientsAreConnected) {
  auto server = std::make_unique<HttpServer>(HttpSettings{}, echo);
  RawClient idle(server->port());
  RawClient begun(server->port());
  begun.send("GET /a HT");
  const auto start = std::chrono::steady_clock::now();
  server.reset();
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

TEST(RateLimit, FillsUpAgainWithTime) {
  RateLimit limit({.burst = 2, .per_second = 1});
  const RateLimit::Clock::time_point start{};
  EXPECT_TRUE(limit.allows("a", start));
  EXPECT_TRUE(limit.allows("a", start));
  EXPECT_FALSE(limit.allows("a", start));
  EXPECT_TRUE(limit.allows("b", start));
  EXPECT_FALSE(limit.allows("a", start + std::chrono::milliseconds(900)));
  EXPECT_TRUE(limit.allows("a", start + std::chrono::milliseconds(1100)));
}

}  // namespace
}  // namespace mien::pipeline
