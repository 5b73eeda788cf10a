// Prints a hash of every kind of result that core has, one per line: compare.sh builds this in several ways and all
// must print the same. `hash libm` prints a hash of the system's own functions instead, which may differ.
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <functional>
#include <initializer_list>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "tuftwave/elementary.hpp"
#include "tuftwave/fill.hpp"
#include "tuftwave/fit.hpp"
#include "tuftwave/hairstyle.hpp"
#include "tuftwave/quality.hpp"
#include "tuftwave/random.hpp"
#include "tuftwave/scalp.hpp"
#include "tuftwave/skinning.hpp"

namespace tuftwave {
namespace {

/// FNV-1a over the bits of numbers.
class Hash {
  public:
    void add(std::uint64_t bits) {
        for (int byte = 0; byte < 8; ++byte) value_ = (value_ ^ (bits >> 8 * byte & 0xff)) * 0x100000001b3;
    }
    void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
    void add(const Vec3& v) {
        for (const double part : {v.x, v.y, v.z}) add(part);
    }
    void add(const Quat& q) {
        for (const double part : {q.x, q.y, q.z, q.w}) add(part);
    }
    template <class Number>
    void add_all(std::span<const Number> numbers) {
        for (const Number number : numbers) add(static_cast<double>(number));
    }
    void print(const std::string& what) const {
        std::printf("%-32s %016llx\n", what.c_str(), static_cast<unsigned long long>(value_));
    }

  private:
    std::uint64_t value_ = 0xcbf29ce484222325;
};

/// Numbers from core's own generator: those of the standard library's distributions differ between libraries.
class Numbers {
  public:
    explicit Numbers(std::uint32_t seed) : seed_(seed) {}
    double between(double low, double high) {
        const auto words = philox4x32({next_++, 0, 0, 0}, {seed_, 0});
        return low + (high - low) * unit_interval(words[0], words[1]);
    }
    int below(int count) { return static_cast<int>(between(0, count)); }
    Vec3 in_cube(double half) {
        const double x = between(-half, half), y = between(-half, half), z = between(-half, half);
        return {x, y, z};
    }

  private:
    std::uint32_t seed_, next_ = 0;
};

void hash_elementary() {
    constexpr int kCount = 200'000;
    const auto print = [](const char* what, double low, double high,
                          const std::function<double(double, double)>& function) {
        Numbers numbers(1);
        Hash hash;
        for (int i = 0; i < kCount; ++i) {
            const double a = numbers.between(low, high), b = numbers.between(-8, 8);
            hash.add(function(a, b));
        }
        hash.print(what);
    };
    print("sin", -1e6, 1e6, [](double a, double) { return elementary::sin(a); });
    print("cos", -7, 7, [](double a, double) { return elementary::cos(a); });
    print("atan2", -9, 9, [](double a, double b) { return elementary::atan2(a, b); });
    print("acos", -1, 1, [](double a, double) { return elementary::acos(a); });
    print("exp", -745, 709, [](double a, double) { return elementary::exp(a); });
    print("log", 1e-300, 1e3, [](double a, double) { return elementary::log(a); });
    print("pow", 0, 40, [](double a, double b) { return elementary::pow(a, b); });
}

void hash_libm() {
    Numbers numbers(1);
    Hash hash;
    for (int i = 0; i < 500'000; ++i) {
        const double a = numbers.between(0, 40), b = numbers.between(-8, 8);
        for (const double result :
             {std::sin(a), std::cos(b), std::atan2(a, b), std::exp(b), std::log(a), std::pow(a, b)})
            hash.add(result);
    }
    hash.print("libm");
}

constexpr Taper kTapers[] = {Taper::kSine, Taper::kLinear, Taper::kSmooth, Taper::kRound};

/// A stroke that wanders outwards from a root on a head of 10 cm radius. @param step  metres between points, at most
Tuft wandering_tuft(Numbers& numbers, double step) {
    Tuft tuft;
    const Vec3 outward = normalized(numbers.in_cube(1) + Vec3{0, 1.2, 0});
    tuft.points.push_back(0.1 * outward);
    for (int i = 0, count = 1 + numbers.below(12); i < count; ++i)
        tuft.points.push_back(tuft.points.back() + 0.5 * step * outward + numbers.in_cube(step));
    tuft.diameter = numbers.between(1, 100);
    tuft.widest_at = numbers.below(8) == 0 ? 100 : numbers.between(1, 100);
    tuft.taper = kTapers[numbers.below(4)];
    if (numbers.below(2) == 0) {
        tuft.section = Section::kEllipse;
        tuft.flatness = numbers.between(0, 0.98);
    }
    tuft.twist_deg = numbers.between(-720, 720);
    tuft.roll_deg = numbers.between(-360, 360);
    tuft.joints = 1 + numbers.below(12);
    tuft.phase = numbers.between(-9, 9);
    return tuft;
}

Hairstyle hairstyle_of(std::uint32_t seed, double step) {
    Numbers numbers(seed);
    Hairstyle hairstyle;
    for (int i = 0; i < 40; ++i) hairstyle.tufts.push_back(wandering_tuft(numbers, step));
    hairstyle.motion.emplace();
    return hairstyle;
}

void add_mesh(Hash& hash, const Mesh& mesh) {
    for (const std::vector<float>* numbers : {&mesh.positions, &mesh.normals, &mesh.uvs, &mesh.weights})
        hash.add_all(std::span(*numbers));
    hash.add_all(std::span(mesh.joints));
    hash.add_all(std::span(mesh.indices));
}

/// How the nodes of all pictures are turned, and the vertices of the last one.
void add_posed(Hash& hash, const Mesh& rest, const Chain& chain, const ChainMotion& moved) {
    for (const Quat& turn : model_turns(chain, moved.rotations)) hash.add(turn);
    std::vector<float> positions(rest.positions.size()), normals(rest.normals.size());
    write_posed_vertices(rest, chain, std::span(moved.rotations).last(chain.nodes.size()), positions, normals);
    for (const auto* numbers : {&positions, &normals}) hash.add_all(std::span<const float>(*numbers));
}

void print_plan(const std::string& what, const Hairstyle& hairstyle) {
    const Result<HairPlan> plan = plan_hairstyle(hairstyle, Limits{}, InOrder(), std::stop_token{});
    if (!plan) {
        std::printf("%-32s refused at %s\n", what.c_str(), plan.error().field.c_str());
        return;
    }
    Hash meshes, motions, posed;
    for (std::size_t i = 0; i < plan->tufts.size(); ++i) {
        const Mesh mesh = to_mesh(plan->tufts[i]);
        add_mesh(meshes, mesh);
        const Chain& chain = plan->chains[i];
        const ChainMotion& moved = plan->motion->chains[i];
        add_posed(posed, mesh, chain, moved);
        for (const Vec3& node : chain.nodes) meshes.add(node);
        for (const Quat& rotation : moved.rotations) motions.add(rotation);
        for (const Vec3& position : node_positions(chain, std::span(moved.rotations).first(chain.nodes.size())))
            motions.add(position);
        motions.add(largest_step(chain, moved));
    }
    meshes.print(what + " meshes");
    motions.print(what + " motions");
    posed.print(what + " posed");
}

void hash_meshes() {
    for (const auto& [name, step] : {std::pair{"smooth", 0.03}, {"tight", 0.004}, {"wide", 30.0}}) {
        Hairstyle hairstyle = hairstyle_of(7, step);
        if (step > 1) hairstyle.mesh.tolerance = 0.3;
        print_plan(name, hairstyle);
        hairstyle.mesh.rings = 17;
        hairstyle.mesh.sides = 5;
        print_plan(std::string(name) + ", 17 rings of 5", hairstyle);
    }
}

void hash_motions() {
    Hairstyle hairstyle = hairstyle_of(11, 0.03);
    Motion& motion = *hairstyle.motion;
    const auto with = [&](const char* what, auto change) {
        const Motion before = motion;
        change();
        print_plan(what, hairstyle);
        motion = before;
    };
    with("one-sided", [&] { motion.one_sided = true; });
    with("absolute", [&] { motion.mode = Mode::kAbsolute; });
    with("absolute, half lifted", [&] { motion.mode = Mode::kAbsolute, motion.lift = 0.5; });
    with("lifted, drooping", [&] { motion.lift = 0.3, motion.droop = Droop::kKeep; });
    with("gust and scatter", [&] { motion.phase = {PhaseStep::kFree, 0.37, 0.8, 9007199254740991, 1}; });
    with("whole pictures", [&] { motion.phase = {PhaseStep::kPicture, 0.37, 0.8, 1, 2}; });
    with("backwards, wild", [&] { motion.wave = {100, -0.05, -0.05, 8}; });
    with("by frame, NTSC", [&] {
        motion.timing = {0.8, {24000, 1001}, 3, ShortHolds::kSpread, Sampling::kByFrame};
        motion.wind = {0.3, -0.2, -5};
    });
}

/// A closed mesh around the head's center whose surface goes in and out. @param radius  metres, at most
ScalpMesh bumpy_scalp(Numbers& numbers, double radius) {
    constexpr std::uint32_t kRows = 20, kColumns = 40;
    ScalpMesh mesh;
    for (std::uint32_t row = 0; row <= kRows; ++row) {
        for (std::uint32_t column = 0; column < kColumns; ++column) {
            const Bearing bearing{2 * kPi * column / kColumns, kPi * row / kRows - kPi / 2};
            mesh.positions.push_back(radius * numbers.between(0.9, 1) * vector_towards(bearing));
        }
    }
    for (std::uint32_t row = 0; row < kRows; ++row) {
        for (std::uint32_t column = 0; column < kColumns; ++column) {
            const std::uint32_t next = (column + 1) % kColumns, here = row * kColumns, above = here + kColumns;
            mesh.triangles.push_back({here + column, here + next, above + next});
            mesh.triangles.push_back({here + column, above + next, above + column});
        }
    }
    return mesh;
}

void add_fill(Hash& hash, const Filled& filled) {
    for (const Tuft& tuft : filled.tufts) {
        for (const Vec3& point : tuft.points) hash.add(point);
        for (const double number : {tuft.diameter, tuft.widest_at, tuft.flatness, tuft.twist_deg, tuft.roll_deg,
                                    tuft.phase, static_cast<double>(tuft.joints)})
            hash.add(number);
        hash.add(static_cast<std::uint64_t>(tuft.origin->index) << 32 |
                 static_cast<std::uint64_t>(tuft.origin->parent.value_or(0)));
    }
    const FillReport& report = filled.report;
    for (const double term : {report.gap.sweep, report.gap.rise, report.gap.gamma, report.gap.distance}) hash.add(term);
    for (const std::size_t count : {report.along, report.crown, report.neck, report.beyond_hairline, report.crowded,
                                    report.off_scalp, report.inside, report.moved_out})
        hash.add(static_cast<std::uint64_t>(count));
}

/// Fills between 25 pairs of tufts, or around the head from the first of each.
void print_fills(const std::string& what, const Head& head, const FillSettings& settings, bool is_ring) {
    Numbers numbers(19);
    const std::optional<Scalp> scalp = Scalp::of(head);
    Hash hash;
    std::size_t tufts = 0;
    for (int i = 0; i < 25; ++i) {
        const Tuft from = wandering_tuft(numbers, 0.03), to = wandering_tuft(numbers, 0.03);
        const Result<FillPlan> plan = plan_fill(from, is_ring ? nullptr : &to, settings, head, Limits{});
        if (!plan) {
            std::printf("%-32s refused at %s\n", what.c_str(), plan.error().field.c_str());
            return;
        }
        const Result<Filled> filled = make_fill(*plan, head, scalp ? &*scalp : nullptr, {}, InOrder(), {});
        add_fill(hash, *filled);
        tufts += filled->tufts.size();
    }
    if (tufts < 100)
        std::printf("%-32s refused: only %zu tufts\n", what.c_str(), tufts);
    else
        hash.print(what);
}

void hash_fills() {
    Numbers numbers(13);
    Head bare, round, bumpy;
    round.scalp = ScalpEllipsoid{Vec3{0.004, -0.01, 0.006}, {0.085, 0.11, 0.095}};
    bumpy.scalp = bumpy_scalp(numbers, 0.1);
    bumpy.up = {0.2, 1, -0.1};
    FillSettings row, everywhere, other;
    row.density = {80, {}, {}};
    everywhere.density = {60, 70, 75};
    everywhere.jitter_seed = 9007199254740991;
    other = everywhere;
    other.spacing = Spacing::kHalfGap;
    other.arc = Arc::kPath;
    other.direction = FillDirection::kShorter;
    other.min_gap = 0.4;
    for (const auto& [place, head] : {std::pair{"no scalp", bare}, {"ellipsoid", round}, {"mesh", bumpy}}) {
        print_fills(std::string("fills along, ") + place, head, row, false);
        print_fills(std::string("fills with jitter, ") + place, head, everywhere, false);
        print_fills(std::string("fills with gaps, ") + place, head, other, false);
        print_fills(std::string("rings, ") + place, head, everywhere, true);
    }
    FillSettings printed = everywhere;
    printed.formulas = Formulas::kAsPrinted;
    printed.resample = true;
    print_fills("fills as printed", bare, printed, false);

    Hairstyle hairstyle = hairstyle_of(17, 0.03);
    hairstyle.head = bumpy;
    hairstyle.fills = {{0, 1, everywhere}, {2, {}, other}, {3, 3, row}};
    print_plan("filled", hairstyle);
}

/// Drawings of a known wave, each node moved a little, and scribbles of no wave at all.
std::vector<Drawing> drawings_of(Numbers& numbers, double noise) {
    std::vector<Drawing> drawings;
    for (int i = 0; i < 30; ++i) {
        const int nodes = 3 + numbers.below(9), pictures = 2 + numbers.below(7);
        Drawing drawing;
        for (int n = 0; n < pictures; ++n) {
            Line line{{0, 0, 0}};
            for (int node = 1; node < nodes; ++node) {
                const double height = 0.1 * node * elementary::cos(0.4 * node - 2 * kPi * n / pictures);
                line.push_back(Vec3{0.1 * node, -height - 0.02 * node, 0} + numbers.in_cube(noise));
            }
            drawing.pictures.push_back(line);
        }
        drawings.push_back(drawing);
    }
    return drawings;
}

void hash_fits() {
    Numbers numbers(23);
    for (const auto& [name, noise] : {std::pair{"fits", 0.002}, {"fits of scribbles", 1.0}}) {
        Hash hash;
        const std::vector<Drawing> drawings = drawings_of(numbers, noise);
        for (const Mode mode : {Mode::kRelative, Mode::kAbsolute}) {
            FitSettings settings;
            settings.mode = mode;
            const Result<std::vector<Fit>> fits = fit_waves(drawings, settings, nullptr, {}, InOrder(), {});
            for (const Fit& fit : *fits) {
                const Wave& wave = fit.wave;
                for (const double number : {wave.amplitude, wave.spatial_period, wave.lightness, wave.tip_exponent,
                                            fit.phase, fit.error.mean.angle, fit.still.mean.position})
                    hash.add(number);
                for (const Vec3& node : fit.rest) hash.add(node);
                hash.add(static_cast<std::uint64_t>(fit.steps));
            }
        }
        hash.print(name);
    }
}

void hash_schedules_and_quality() {
    Numbers numbers(3);
    Hash schedules, crossings;
    for (int i = 0; i < 20'000; ++i) {
        Timing timing;
        timing.period = numbers.between(0.01, 3);
        timing.fps = to_frame_rate(numbers.between(1, 240));
        timing.hold = 1 + numbers.below(24);
        timing.short_holds = numbers.below(2) == 0 ? ShortHolds::kLast : ShortHolds::kSpread;
        const Result<Schedule> schedule = make_schedule(timing, Formulas::kCorrected, Limits{});
        if (!schedule) continue;
        schedules.add(schedule->period);
        for (int n = 0; n < schedule->pictures; ++n)
            schedules.add(picture_phase(*schedule, n) + schedule->starts[static_cast<std::size_t>(n)]);
    }
    for (int i = 0; i < 50; ++i) {
        const Wave wave{numbers.between(0, 3), numbers.between(0.2, 3), numbers.between(0.5, 3),
                        numbers.between(0.2, 3)};
        crossings.add(static_cast<std::uint64_t>(tip_crossings(wave, 16)));
    }
    schedules.print("schedules");
    crossings.print("tip crossings");
}

}  // namespace
}  // namespace tuftwave

int main(int count, char** arguments) {
    if (count > 1 && std::strcmp(arguments[1], "libm") == 0) {
        tuftwave::hash_libm();
        return 0;
    }
    tuftwave::hash_elementary();
    tuftwave::hash_meshes();
    tuftwave::hash_motions();
    tuftwave::hash_fills();
    tuftwave::hash_fits();
    tuftwave::hash_schedules_and_quality();
}
