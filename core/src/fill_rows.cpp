// Based on: Shimosoyama, Yamamoto, Noma. NPR Hair Modeling by Controlling the Shape of Tufts. Sections 4.2 and 4.3,
// equations (7) and (8).
// Differs: the hair line (8) is drawn after the jitter, so that it holds for every root.
#include "tuftwave/fill_rows.hpp"

#include <algorithm>

#include "tuftwave/random.hpp"

namespace tuftwave {
namespace {

/// The jitter of azimuth and of elevation, radians either way: 9 degrees.
constexpr double kJitter = kPi / 20;

class RowLayer {
  public:
    RowLayer(std::span<const Bearing> roots, std::optional<std::uint64_t> seed, std::size_t most)
        : roots_(roots), seed_(seed), most_(most) {}

    void add_along() {
        for (std::size_t l = 1; l + 1 < roots_.size(); ++l)
            add({FillKind::kAlong, static_cast<int>(l), {}}, l, 0, jitter(l, 0, RandomUse::kAlong));
    }

    void add_copies(std::size_t parents, double density, FillKind kind) {
        const double step = (90 - 0.81 * density) * kRadiansPerDegree;  // eq. (7)
        const double sign = kind == FillKind::kCrown ? 1 : -1;
        const RandomUse use = kind == FillKind::kCrown ? RandomUse::kCrown : RandomUse::kNeck;
        for (std::size_t parent = 0; parent < parents; ++parent) {
            const std::size_t o = parent + 1;
            for (int y = 1; sign * roots_[parent].elevation + y * step < kPi / 2 - kSameAngle; ++y)
                add({kind, y, static_cast<int>(o)}, parent, sign * y * step,
                    jitter(o, static_cast<std::uint32_t>(y), use));
        }
    }

    Rows take() { return std::move(rows_); }

  private:
    /// Section 4.3. Two uniform numbers for azimuth and elevation.
    Bearing jitter(std::size_t o, std::uint32_t y, RandomUse use) const {
        if (!seed_) return {};
        const auto words = philox4x32({static_cast<std::uint32_t>(o), y, static_cast<std::uint32_t>(use), 0},
                                      {static_cast<std::uint32_t>(*seed_), static_cast<std::uint32_t>(*seed_ >> 32)});
        return {(2 * unit_interval(words[0], words[1]) - 1) * kJitter,
                (2 * unit_interval(words[2], words[3]) - 1) * kJitter};
    }

    void add(const Origin& origin, std::size_t parent, double rise, const Bearing& jitter) {
        const Bearing& root = roots_[parent];
        const double elevation = std::clamp(root.elevation + rise + jitter.elevation, -kPi / 2, kPi / 2);
        if (origin.kind == FillKind::kNeck && !is_within_hairline({root.azimuth + jitter.azimuth, elevation})) {
            ++rows_.beyond_hairline;
            return;
        }
        ++rows_.count;
        if (rows_.count <= most_)
            rows_.placements.push_back({origin, parent, {jitter.azimuth, elevation - root.elevation}});
    }

    std::span<const Bearing> roots_;
    std::optional<std::uint64_t> seed_;
    std::size_t most_;
    Rows rows_;
};

}  // namespace

Rows lay_rows(std::span<const Bearing> roots, bool is_to_copied, const Densities& density,
              std::optional<std::uint64_t> jitter_seed, std::size_t most) {
    const std::size_t parents = is_to_copied ? roots.size() : roots.size() - 1;
    RowLayer layer(roots, jitter_seed, most);
    layer.add_along();
    if (is_on(density.crown)) layer.add_copies(parents, *density.crown, FillKind::kCrown);
    if (is_on(density.neck)) layer.add_copies(parents, *density.neck, FillKind::kNeck);
    return layer.take();
}

}  // namespace tuftwave
