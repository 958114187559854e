// Plays the shots against one engine and prints one line of JSON: node/harness.mjs in C++, experiment by experiment.
#pragma once
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

constexpr double kMass = 0.43, kRadius = 0.11, kInertia = 2.0 / 3 * kMass * kRadius * kRadius;
constexpr double kGravity = 9.81, kRestitution = 0.6, kFriction = 0.5;
constexpr double kPostZ = -20, kPostRadius = 0.06, kPostHeight = 2.5;
// The lever arm of the rolling resistance, m, at which a rolling ball loses 1 m/s every second: 5 m/s lead 12.5 m far.
constexpr double kRollingArm = kRadius * (1 + 2.0 / 3) / kGravity;
constexpr double kFrame = 1.0 / 60;

// Position, orientation, velocity, spin.
using State = std::array<double, 13>;
using Vec = std::array<double, 3>;

struct Options {
    bool ground = false, post = false, ccd = false, rolling = false;
    double step = kFrame;
    int count = 1;
};

struct Engine {
    const char *name, *version, *build;
    bool canCcd, canRoll;
};

inline double now() {
    return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// World(Options) has add(position, velocity, spin), step(h), get(i), set(i, State), and save() and restore(saved) for one ball.
template <class World> class Harness {
    std::vector<double> drops;
    std::vector<std::array<double, 2>> postShots;
    std::vector<std::array<double, 6>> kicks;

    static void kick(World &world, const std::array<double, 6> &k, Vec from = {0, 1, 0}) {
        world.add(from, {k[0], k[1], k[2]}, {k[3], k[4], k[5]});
    }

    static std::vector<State> path(World &world, int steps) {
        std::vector<State> states;
        for (int i = 0; i < steps; i++) {
            world.step(kFrame);
            states.push_back(world.get(0));
        }
        return states;
    }

    static bool equal(const std::vector<State> &a, const std::vector<State> &b) {
        return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(State)) == 0;
    }

    double costOfOne() {
        World world(Options{.ground = true});
        kick(world, kicks[0]);
        State start = world.get(0);
        double least = INFINITY;
        for (int round = 0; round < 400; round++) {
            world.set(0, start);
            double from = now();
            for (int i = 0; i < 60; i++) world.step(kFrame);
            least = std::min(least, (now() - from) / 60);
        }
        return least;
    }

    // Balls do not collide with each other: every engine has the same contacts.
    double costOfMany() {
        constexpr int count = 10000;
        World world(Options{.ground = true, .count = count});
        std::vector<State> starts;
        for (int i = 0; i < count; i++) kick(world, kicks[i], {3.0 * (i % 100), 1, 3.0 * (i / 100)});
        for (int i = 0; i < count; i++) starts.push_back(world.get(i));
        double least = INFINITY;
        for (int round = 0; round < 10; round++) {
            for (int i = 0; i < count; i++) world.set(i, starts[i]);
            double from = now();
            for (int i = 0; i < 60; i++) world.step(kFrame);
            least = std::min(least, (now() - from) / 60 / count);
        }
        return least;
    }

    // The greatest height between the first bounce and the second. A frame of more than 1/60 s becomes equal steps of at most 1/60 s: manuals ask for it.
    static double apex(double from, double frameTime) {
        const int parts = std::max(1, static_cast<int>(std::ceil(frameTime * 60 - 0.01)));
        const double h = frameTime / parts;
        World world(Options{.ground = true, .step = h});
        world.add({0, from, 0}, {}, {});
        double top = 0;
        bool rises = false;
        for (int i = 0; i * h < 3; i++) {
            world.step(h);
            State s = world.get(0);
            if (s[8] > 0) rises = true;
            if (rises) top = std::max(top, s[1]);
            if (rises && s[8] < 0) break;
        }
        return top;
    }

    // A hit turns the ball by more than 2 degrees, or back.
    int posts(bool ccd, int rate) {
        int hits = 0;
        for (auto &[x, z] : postShots) {
            World world(Options{.post = true, .ccd = ccd, .step = 1.0 / rate});
            world.add({x, 1, z}, {0, 3, -40}, {});
            for (int i = 0; i < 0.75 * rate; i++) world.step(1.0 / rate);
            State s = world.get(0);
            if (-s[9] < std::cos(M_PI / 90) * std::hypot(s[7], s[9])) hits++;
        }
        return hits;
    }

    static double roll() {
        World world(Options{.ground = true, .rolling = true});
        world.add({0, kRadius, 0}, {0, 0, -5}, {-5 / kRadius, 0, 0});
        for (int i = 0; i < 1800; i++) world.step(kFrame);
        return -world.get(0)[2];
    }

    // A second world starts from the state that the first saved 40 steps after the kick, and runs 3 s ahead. How far is it from the first?
    void predict(double &least, double &off) {
        least = INFINITY, off = 0;
        World second(Options{.ground = true});
        second.add({0, 1, 0}, {}, {});
        for (int k = 0; k < 20; k++) {
            World world(Options{.ground = true});
            kick(world, kicks[k]);
            for (int i = 0; i < 40; i++) world.step(kFrame);
            auto state = world.save();
            std::vector<State> ahead;
            for (int round = 0; round < 5; round++) {
                double from = now();
                second.restore(state);
                ahead = path(second, 180);
                least = std::min(least, (now() - from) / 1000);
            }
            for (auto &s : ahead) {
                world.step(kFrame);
                State t = world.get(0);
                off = std::max(off, std::hypot(s[0] - t[0], s[1] - t[1], s[2] - t[2]));
            }
        }
    }

    // Saves 40 steps after the kick, plays 120 steps, goes back and plays them again.
    int restore(double &least) {
        int again = 0;
        least = INFINITY;
        for (int k = 0; k < 20; k++) {
            World world(Options{.ground = true});
            kick(world, kicks[k]);
            path(world, 40);
            for (int round = 0; round < 20; round++) {
                double from = now();
                for (int i = 0; i < 50; i++) {
                    auto saved = world.save();
                    world.restore(saved);
                }
                least = std::min(least, (now() - from) / 50);
            }
            auto saved = world.save();
            auto first = path(world, 120);
            world.restore(saved);
            again += equal(first, path(world, 120));
        }
        return again;
    }

    int same() {
        int count = 0;
        for (int k = 0; k < 20; k++) {
            std::vector<State> paths[2];
            for (auto &p : paths) {
                World world(Options{.ground = true, .post = true});
                kick(world, kicks[k]);
                p = path(world, 180);
            }
            count += equal(paths[0], paths[1]);
        }
        return count;
    }

public:
    explicit Harness(const char *file) {
        std::ifstream in(file);
        for (std::string line; std::getline(in, line);) {
            std::istringstream words(line);
            std::string kind;
            words >> kind;
            std::vector<double> n;
            for (double x; words >> x;) n.push_back(x);
            if (kind == "drop") drops.push_back(n[0]);
            if (kind == "post") postShots.push_back({n[0], n[1]});
            if (kind == "kick") kicks.push_back({n[0], n[1], n[2], n[3], n[4], n[5]});
        }
    }

    // stateBytes: the size of the saved state in the engine's own precision.
    void run(const Engine &e, int stateBytes) {
        std::printf("{\"name\":\"%s\",\"version\":\"%s\",\"build\":\"%s\",\"saved\":\"by hand\"", e.name, e.version, e.build);
        std::printf(",\"cost1\":%.17g,\"cost10k\":%.17g,\"tops\":[", costOfOne(), costOfMany());
        const double steps[] = {0.005, 0.01, kFrame, 0.04};
        for (int i = 0; i < 4; i++) std::printf("%s%.17g", i ? "," : "", apex(2, steps[i]));
        double low = INFINITY, high = 0;
        for (double from : drops) {
            double r = std::sqrt((apex(from, kFrame) - kRadius) / (from - kRadius));
            low = std::min(low, r), high = std::max(high, r);
        }
        std::printf("],\"reboundLow\":%.17g,\"reboundHigh\":%.17g", low, high);
        std::printf(",\"post60\":%d,\"post240\":%d", posts(false, 60), posts(false, 240));
        e.canCcd ? std::printf(",\"postCcd\":%d", posts(true, 60)) : std::printf(",\"postCcd\":null");
        e.canRoll ? std::printf(",\"roll\":%.17g", roll()) : std::printf(",\"roll\":null");
        double us, off, ns;
        predict(us, off);
        int again = restore(ns);
        std::printf(",\"predictUs\":%.17g,\"predictOff\":%.17g,\"bytes\":%d,\"saveNs\":%.17g,\"again\":%d,\"same\":%d}\n", us, off, stateBytes, ns, again, same());
    }
};
