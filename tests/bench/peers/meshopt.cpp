// The library's own encode calls on W1's vertices, quantised as KHR_mesh_quantization has them, and on its indices.
//
//   tuftwave_bench_meshopt FOLDER      with w1.json and w2.json
//
// What the service makes of it prints meshopt/tuftwave and meshopt_size/tuftwave (tests/bench/ours).
#include <meshoptimizer.h>

#include <cstdint>
#include <cstdio>
#include <vector>

#include "afternoon/hair.hpp"
#include "measure.hpp"
#include "workloads.hpp"

namespace {

using namespace tuftwave::bench;

struct Position {
    std::int16_t x, y, z, padding;
};
struct Normal {
    std::int8_t x, y, z, padding;
};
struct Place {
    std::uint16_t u, v;
};

struct Quantised {
    std::vector<Position> positions;
    std::vector<Normal> normals;
    std::vector<Place> uvs;
};

Quantised quantised(const afternoon::Mesh& mesh) {
    const auto wide = [](float value) { return static_cast<std::int16_t>(meshopt_quantizeSnorm(value, 16)); };
    const auto narrow = [](float value) { return static_cast<std::int8_t>(meshopt_quantizeSnorm(value, 8)); };
    const auto share = [](float value) { return static_cast<std::uint16_t>(meshopt_quantizeUnorm(value, 16)); };
    Quantised all;
    for (const glm::vec3& p : mesh.positions) all.positions.push_back({wide(p.x), wide(p.y), wide(p.z), 0});
    for (const glm::vec3& n : mesh.normals) all.normals.push_back({narrow(n.x), narrow(n.y), narrow(n.z), 0});
    for (const glm::vec2& uv : mesh.uvs) all.uvs.push_back({share(uv.x), share(uv.y)});
    return all;
}

template <class Vertex>
std::size_t encode(const std::vector<Vertex>& vertices) {
    static std::vector<unsigned char> room;
    room.resize(meshopt_encodeVertexBufferBound(vertices.size(), sizeof(Vertex)));
    return meshopt_encodeVertexBuffer(room.data(), room.size(), vertices.data(), vertices.size(), sizeof(Vertex));
}

std::size_t encode_triangles(const std::vector<unsigned>& indices, std::size_t vertices) {
    static std::vector<unsigned char> room;
    room.resize(meshopt_encodeIndexBufferBound(indices.size(), vertices));
    return meshopt_encodeIndexBuffer(room.data(), room.size(), indices.data(), indices.size());
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 2) return std::fputs("usage: tuftwave_bench_meshopt FOLDER\n", stderr), 2;
    afternoon::Mesh mesh;
    for (const Line& line : read_workloads(arguments[1]).strokes) {
        afternoon::Points points;
        for (const Point& point : line) points.emplace_back(point[0], point[1], point[2]);
        afternoon::add_tube(mesh, points);
    }
    const Quantised all = quantised(mesh);
    std::size_t bytes = 0;
    measure("meshopt/library", [&] {
        bytes = encode(all.positions) + encode(all.normals) + encode(all.uvs) +
                encode_triangles(mesh.indices, mesh.positions.size());
    });
    const double whole = static_cast<double>(mesh.positions.size() * 32 + mesh.indices.size() * 4);
    print_value("meshopt_size/library", 100 * static_cast<double>(bytes) / whole, "%");
}
