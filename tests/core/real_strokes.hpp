#pragma once

#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "samples.hpp"
#include "tuftwave/tuft.hpp"

/// Strokes that nobody in this project drew, see tests/data/README.md.
namespace tuftwave::test {

inline const std::filesystem::path kDataDirectory = TUFTWAVE_TEST_DATA;

inline std::string file_bytes(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// The tufts of a hairstyle drawn in VRoid Studio by the tool's groups, in the space of its head bone, metres; none
/// where the file is missing.
inline std::map<std::size_t, std::vector<Tuft>> vroid_groups(const std::string& character) {
    const std::string bytes = file_bytes(kDataDirectory / "strokes" / ("vroid_" + character + ".strokes.json"));
    std::map<std::size_t, std::vector<Tuft>> groups;
    const nlohmann::json document = nlohmann::json::parse(bytes, nullptr, false);
    if (document.is_discarded()) return groups;
    std::size_t number = 0;
    for (const nlohmann::json& stroke : document.at("strokes")) {
        std::vector<Vec3> points;
        for (const nlohmann::json& point : stroke.at("points"))
            points.push_back({point.at(0), point.at(1), point.at(2)});
        Tuft tuft = tuft_along(character + " " + std::to_string(number++), points);
        tuft.diameter = stroke.at("width").get<double>() * 1000;  // of head.diameter_at_100, 10 cm, in percent
        const double flatness = 1 - stroke.at("thickness").get<double>() / stroke.at("width").get<double>();
        if (flatness > 0) tuft.section = Section::kEllipse, tuft.flatness = flatness;
        groups[stroke.at("group").get<std::size_t>()].push_back(std::move(tuft));
    }
    return groups;
}

/// All of them.
inline std::vector<Tuft> vroid_tufts(const std::string& character) {
    std::vector<Tuft> tufts;
    for (auto& [group, strokes] : vroid_groups(character)) tufts.insert(tufts.end(), strokes.begin(), strokes.end());
    return tufts;
}

/// The strands of a TressFX 3.0 file, a head of their own, converted from centimetres; none where the file is missing.
inline std::vector<Tuft> tressfx_strands(const std::string& part) {
    constexpr std::size_t kHeader = 296, kPoints = 16, kPoint = 3 * sizeof(float);
    constexpr double kMetresPerCentimetre = 0.01;
    const std::string bytes = file_bytes(kDataDirectory / "strands" / ("tressfx_ponytail_" + part + ".tfx"));
    std::vector<Tuft> tufts;
    for (std::size_t at = kHeader; at + kPoints * kPoint <= bytes.size(); at += kPoints * kPoint) {
        std::vector<Vec3> points;
        for (std::size_t i = 0; i < kPoints; ++i) {
            float xyz[3];
            std::memcpy(xyz, &bytes[at + i * kPoint], kPoint);
            points.push_back(kMetresPerCentimetre * Vec3{xyz[0], xyz[1], xyz[2]});
        }
        Tuft tuft = tuft_along(part + " " + std::to_string(tufts.size()), points);
        tuft.diameter = 3;
        tufts.push_back(std::move(tuft));
    }
    return tufts;
}

}  // namespace tuftwave::test
