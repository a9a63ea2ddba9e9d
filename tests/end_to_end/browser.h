#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace mien::test {

/// The name of a Chromium that PATH leads to; empty without.
std::string chromium();

/// Opens a page from disk in `chromium`, without a window and without a network, and runs the body
/// of an asynchronous function in it, once it is loaded. `press(key, shift)` presses a key where
/// the focus is and waits until that is drawn; `wait(milliseconds)` waits. Returns what it returns,
/// or {"error"}: what it threw, or what else went wrong.
nlohmann::json in_browser(const std::filesystem::path& page, const std::string& body);

}  // namespace mien::test
