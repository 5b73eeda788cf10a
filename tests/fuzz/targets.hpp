#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tuftwave::server::fuzz {

/// Something that takes bytes from strangers. It must take any: what is wrong is said by `require`, which ends the
/// process, or by a sanitizer.
struct Target {
    std::string name;
    void (*run)(const Target& target, std::string_view input);
    std::string path = "";    ///< of an operation
    bool takes_file = false;  ///< its input ends with a GLB
};

/// One for each route with a body, called after its path ("/v1/characters/motion" is "characters_motion"), and the
/// rest.
std::vector<Target> targets();

/// The target of that name, or null.
const Target* find_target(std::string_view name);

/// Ends the process where something that must hold does not.
void require(bool holds, std::string_view what);

// Each in the .cpp of its name.
void run_operation(const Target& target, std::string_view input);
void run_glb(const Target& target, std::string_view input);
void run_json(const Target& target, std::string_view input);
void run_poses(const Target& target, std::string_view input);
void run_query(const Target& target, std::string_view input);
void run_request(const Target& target, std::string_view input);
void run_sheets(const Target& target, std::string_view input);

}  // namespace tuftwave::server::fuzz
