// The tree beside Embree 3, single rays on one thread, interleaved in one run: medians of rounds.
//   accel_bench [--mesh 20k|500k|4M|room]... [--rounds N] [--size N] [--high] [--json FILE]
// --high builds Embree's high quality for the 4M mesh too; elsewhere it is always there.
#include "accel_meshes.h"
#include "rt/accel/mesh_tree.h"
#include "rt/geometry/triangle.h"

// Compiled into this program, for the instruction set that it is built for.
#include "../../src/accel/mesh_tree.cpp"

#include <embree3/rtcore.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <functional>
#include <optional>

namespace rt::bench {
namespace {

#if defined(__AVX512F__)
constexpr const char* kVariant = "AVX-512";
#elif defined(__AVX2__)
constexpr const char* kVariant = "AVX2";
#else
constexpr const char* kVariant = "baseline";
#endif

constexpr int kBuildThreads = 2;

double secondsOf(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// CPU time of this thread: what else the machine does counts less.
double threadSecondsOf(const std::function<std::size_t()>& work) {
    const auto now = [] {
        timespec time;
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
    };
    const double start = now();
    work();
    return now() - start;
}

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + long(values.size() / 2), values.end());
    return values[values.size() / 2];
}

std::atomic<std::int64_t> embreeBytes{0};

bool countBytes(void*, ssize_t bytes, bool) {
    embreeBytes += bytes;
    return true;
}

/// A robust Embree scene of one mesh.
class EmbreeScene {
  public:
    EmbreeScene(RTCDevice device, const TriangleMesh& mesh, RTCBuildQuality quality)
        : scene_(rtcNewScene(device)) {
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
        rtcSetSceneBuildQuality(scene_, quality);
        const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* positions = static_cast<float*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                    3 * sizeof(float), mesh.positions.size()));
        for (const Vec3& p : mesh.positions) {
            for (int axis = 0; axis < 3; ++axis) *positions++ = static_cast<float>(p[axis]);
        }
        void* indices =
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                    3 * sizeof(Index), mesh.triangles.size());
        std::memcpy(indices, mesh.triangles.data(), mesh.triangles.size() * 3 * sizeof(Index));
        rtcSetGeometryBuildQuality(geometry, quality);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        const std::int64_t before = embreeBytes;
        buildSeconds = secondsOf([&] { rtcCommitScene(scene_); });
        bytes = embreeBytes - before;
    }
    ~EmbreeScene() { rtcReleaseScene(scene_); }
    EmbreeScene(const EmbreeScene&) = delete;

    std::size_t trace(const RaySet& set) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        std::size_t hits = 0;
        for (const Ray& ray : set.rays) {
            RTCRayHit query{};
            RTCRay& r = query.ray;
            r.org_x = float(ray.origin.x), r.org_y = float(ray.origin.y);
            r.org_z = float(ray.origin.z);
            r.dir_x = float(ray.direction.x), r.dir_y = float(ray.direction.y);
            r.dir_z = float(ray.direction.z);
            r.tnear = float(set.tMin), r.tfar = float(set.tMax);
            r.mask = ~0u;
            query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            if (set.anyHit) {
                rtcOccluded1(scene_, &context, &r);
                hits += r.tfar < 0.0f;
            } else {
                rtcIntersect1(scene_, &context, &query);
                hits += query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
            }
        }
        return hits;
    }

    double buildSeconds = 0.0;
    std::int64_t bytes = 0;

  private:
    RTCScene scene_;
};

std::size_t traceOwn(const MeshTree& tree, const RaySet& set) {
    std::size_t hits = 0;
    const Interval range{set.tMin, set.tMax};
    for (const Ray& ray : set.rays) {
        PrimitiveHit hit;
        hits += set.anyHit ? tree.anyHit(ray, range) : tree.closestHit(ray, range, hit);
    }
    return hits;
}

struct Settings {
    std::vector<std::string> meshes{"20k", "500k", "4M", "room"};
    int rounds = 5;
    int size = 512;
    bool high = false;
    std::string json;
};

struct Subject {
    std::string name;
    TriangleMesh mesh;
    Ray view;
};

Subject makeSubject(const std::string& name) {
    const Ray outside{{0.4, 0.9, 2.6}, {-0.4, -0.9, -2.6}};
    if (name == "20k") return {name, Icosphere::make(32), outside};
    if (name == "500k") return {name, Icosphere::make(158), outside};
    if (name == "4M") return {name, Icosphere::make(447), outside};
    if (name == "room") return {name, Room::make(), {{-18, 5, 9}, {1.0, -0.15, -0.5}}};
    throw std::invalid_argument("unknown mesh " + name + "; there are 20k, 500k, 4M, room");
}

/// Median Mrays/s of several tracers, taken in turn.
std::vector<double> race(const std::vector<std::function<std::size_t()>>& tracers, std::size_t rays,
                         int rounds) {
    std::vector<std::vector<double>> seconds(tracers.size());
    for (int round = -1; round < rounds; ++round) {
        for (std::size_t i = 0; i < tracers.size(); ++i) {
            const double s = threadSecondsOf(tracers[i]);
            if (round >= 0) seconds[i].push_back(s);
        }
    }
    std::vector<double> rates;
    for (const auto& s : seconds) rates.push_back(double(rays) / median(s) / 1e6);
    return rates;
}

nlohmann::json benchMesh(const Subject& subject, RTCDevice device, const Settings& settings,
                         std::vector<double>& ratios) {
    const TriangleMesh& mesh = subject.mesh;
    const double triangles = double(mesh.triangles.size());
    MeshTree tree;
    const double own = secondsOf([&] { tree = MeshTree::build(mesh, kBuildThreads); });
    const EmbreeScene medium(device, mesh, RTC_BUILD_QUALITY_MEDIUM);
    std::optional<EmbreeScene> high;
    if (subject.name != "4M" || settings.high) high.emplace(device, mesh, RTC_BUILD_QUALITY_HIGH);
    const double again = secondsOf([&] { tree = MeshTree::build(mesh, kBuildThreads); });
    const double best = std::min(own, again);
    fmt::print(
        "\n{} ({} triangles): build {:.3f} s, {:.1f} bytes a triangle; Embree medium {:.3f} s, "
        "{:.1f} bytes",
        subject.name, mesh.triangles.size(), best, double(tree.bytes()) / triangles,
        medium.buildSeconds, double(medium.bytes) / triangles);
    if (high) {
        fmt::print("; high {:.3f} s, {:.1f} bytes", high->buildSeconds,
                   double(high->bytes) / triangles);
    }
    fmt::print("\n  {:<12}{:>10}{:>10}{:>10}{:>10}   hits\n", "Mrays/s", "own", "medium", "high",
               "ratio");
    nlohmann::json result{{"triangles", mesh.triangles.size()},
                          {"buildSeconds", best},
                          {"bytes", tree.bytes()},
                          {"embreeBuildSeconds", medium.buildSeconds},
                          {"embreeBytes", medium.bytes}};
    for (const RaySet& set : makeRays(mesh, tree, subject.view, settings.size)) {
        std::vector<std::function<std::size_t()>> tracers{[&] { return traceOwn(tree, set); },
                                                          [&] { return medium.trace(set); }};
        if (high) tracers.push_back([&] { return high->trace(set); });
        const std::vector<double> rates = race(tracers, set.rays.size(), settings.rounds);
        const double rival = *std::max_element(rates.begin() + 1, rates.end());
        ratios.push_back(rates[0] / rival);
        fmt::print("  {:<12}{:>10.2f}{:>10.2f}{:>10}{:>10.2f}   {} / {}\n", set.name, rates[0],
                   rates[1], high ? fmt::format("{:.2f}", rates[2]) : "-", ratios.back(),
                   traceOwn(tree, set), medium.trace(set));
        result[set.name] = {{"own", rates[0]}, {"embree", rival}, {"ratio", ratios.back()}};
        std::fflush(stdout);
    }
    return result;
}

/// Moeller and Trumbore's test (JGT 2(1), 1997) in double, as the plain measure.
bool moellerTrumbore(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c, Interval range,
                     PrimitiveHit& hit) {
    const Vec3 e1 = b - a, e2 = c - a;
    const Vec3 p = glm::cross(ray.direction, e2);
    const double determinant = glm::dot(e1, p);
    if (determinant == 0.0) return false;
    const double inverse = 1.0 / determinant;
    const Vec3 s = ray.origin - a;
    const double u = glm::dot(s, p) * inverse;
    if (!(u >= 0.0 && u <= 1.0)) return false;
    const Vec3 q = glm::cross(s, e1);
    const double v = glm::dot(ray.direction, q) * inverse;
    if (!(v >= 0.0 && u + v <= 1.0)) return false;
    const double t = glm::dot(e2, q) * inverse;
    if (!range.contains(t)) return false;
    hit = {t, {1.0 - u - v, u, v}, 0};
    return true;
}

nlohmann::json benchTriangle(int rounds) {
    std::mt19937_64 random(3);
    std::vector<std::array<Vec3, 3>> triangles(1024);
    std::vector<Ray> rays(256);
    for (auto& corners : triangles) {
        const Vec3 centre = 2.0 * unitVector(random);
        for (Vec3& corner : corners) corner = centre + unitVector(random);
    }
    for (Ray& ray : rays) ray = {0.5 * unitVector(random), unitVector(random)};
    const auto each = [&](auto&& prepare, auto&& test) {
        std::size_t hits = 0;
        for (const Ray& ray : rays) {
            const auto prepared = prepare(ray);
            for (const auto& c : triangles) {
                PrimitiveHit hit;
                hits += test(prepared, c[0], c[1], c[2], Interval{}, hit);
            }
        }
        return hits;
    };
    const std::vector<double> both =
        race({[&] {
                  return each([](const Ray& ray) { return TriangleRay(ray); },
                              [](const TriangleRay& ray, const Vec3& a, const Vec3& b,
                                 const Vec3& c, Interval range, PrimitiveHit& hit) {
                                  return intersectTriangle(ray, a, b, c, range, hit);
                              });
              },
              [&] { return each([](const Ray& ray) { return ray; }, moellerTrumbore); }},
             rays.size() * triangles.size(), rounds);
    fmt::print(
        "\none triangle, scalar: {:.2f} ns; Moeller-Trumbore in double {:.2f} ns; ratio {:.2f}\n",
        1e3 / both[0], 1e3 / both[1], both[1] / both[0]);
    return {{"ns", 1e3 / both[0]}, {"moellerTrumboreNs", 1e3 / both[1]}};
}

Settings parse(int count, char** arguments) {
    Settings settings;
    std::vector<std::string> meshes;
    for (int i = 1; i < count; ++i) {
        const std::string word = arguments[i];
        const auto value = [&] {
            if (++i == count) throw std::invalid_argument(word + " needs a value");
            return std::string(arguments[i]);
        };
        if (word == "--mesh")
            meshes.push_back(value());
        else if (word == "--rounds")
            settings.rounds = std::stoi(value());
        else if (word == "--size")
            settings.size = std::stoi(value());
        else if (word == "--json")
            settings.json = value();
        else if (word == "--high")
            settings.high = true;
        else
            throw std::invalid_argument("unknown option " + word);
    }
    if (!meshes.empty()) settings.meshes = meshes;
    return settings;
}

void run(const Settings& settings) {
    fmt::print("own tree: {}; {} x {} rays, medians of {} rounds\n", kVariant, settings.size,
               settings.size, settings.rounds);
    nlohmann::json report{{"variant", kVariant}};
    report["triangle"] = benchTriangle(4 * settings.rounds + 1);
    const RTCDevice device = rtcNewDevice(fmt::format("threads={}", kBuildThreads).c_str());
    rtcSetDeviceMemoryMonitorFunction(device, countBytes, nullptr);
    std::vector<double> ratios;
    for (const std::string& name : settings.meshes) {
        report["meshes"][name] = benchMesh(makeSubject(name), device, settings, ratios);
    }
    rtcReleaseDevice(device);
    double logarithms = 0.0;
    for (const double ratio : ratios) logarithms += std::log(ratio);
    const double mean = std::exp(logarithms / double(ratios.size()));
    const double least = *std::min_element(ratios.begin(), ratios.end());
    fmt::print("\nratio to Embree robust: least {:.2f}, geometric mean {:.2f}\n", least, mean);
    report["least"] = least;
    report["mean"] = mean;
    if (!settings.json.empty()) std::ofstream(settings.json) << report.dump(2) << '\n';
}

}  // namespace
}  // namespace rt::bench

int main(int count, char** arguments) {
#if defined(__AVX512F__)
    if (!__builtin_cpu_supports("avx512dq")) {
        fmt::print(stderr, "accel_bench: built for AVX-512, which this processor lacks\n");
        return 2;
    }
#endif
    try {
        rt::bench::run(rt::bench::parse(count, arguments));
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "accel_bench: {}\n", error.what());
        return 2;
    }
}
