// Easing curves, and tweens frame by frame.
#include <catch2/catch.hpp>
#include <cmath>

#include "bind/easing.h"
#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

/// One frame of the game.
void frame(LuaBench& bench, int count = 1) {
    for (int i = 0; i < count; ++i) {
        const auto error = bench.game().update({});
        if (error) FAIL(error->to_text());
    }
}

double number(LuaBench& bench, const std::string& expression) {
    return std::stod(bench.value(expression));
}

}  // namespace

TEST_CASE("every curve takes 0 to 0 and 1 to 1, and the sides mirror each other") {
    REQUIRE(ease_names().size() == 1 + 10 * 3);
    for (const std::string& name : ease_names()) {
        INFO(name);
        const auto ease = ease_from_name(name);
        REQUIRE(ease);
        CHECK(eased(*ease, 0) == 0);
        CHECK(eased(*ease, 1) == 1);
        CHECK(eased(*ease, -3) == 0);
        CHECK(eased(*ease, std::nan("")) == 0);
        // Continuous: no step of a thousandth moves more than the steepest curve does.
        for (int i = 0; i < 1000; ++i) {
            const double t = i / 1000.0;
            CHECK(std::abs(eased(*ease, t + 0.001) - eased(*ease, t)) < 0.05);
        }
    }
    for (int curve = 0; curve < kEaseCurveCount; ++curve) {
        for (double t = 0.05; t < 1; t += 0.05) {
            const auto c = static_cast<EaseCurve>(curve);
            INFO(curve << " at " << t);
            CHECK(eased({c, EaseSide::Out}, t) == Approx(1 - eased({c, EaseSide::In}, 1 - t)).margin(1e-12));
            CHECK(eased({c, EaseSide::InOut}, t) ==
                  Approx(1 - eased({c, EaseSide::InOut}, 1 - t)).margin(1e-12));
        }
    }
    CHECK_FALSE(ease_from_name("quad"));
    CHECK_FALSE(ease_from_name("linear_in"));
    CHECK_FALSE(ease_from_name("quad_sideways"));
}

TEST_CASE("curves have the values of their formulas") {
    const auto at = [](const char* name, double t) { return eased(*ease_from_name(name), t); };
    CHECK(at("linear", 0.3) == 0.3);
    CHECK(at("quad_in", 0.5) == 0.25);
    CHECK(at("cubic_out", 0.5) == 0.875);
    CHECK(at("quart_in", 0.5) == 0.0625);
    CHECK(at("quint_in", 0.5) == 0.03125);
    CHECK(at("sine_in", 0.5) == Approx(1 - std::cos(3.14159265358979 / 4)).epsilon(1e-6));
    CHECK(at("expo_in", 0.5) == Approx((32 - 1) / 1023.0).epsilon(1e-6));
    CHECK(at("circ_in", 0.6) == Approx(0.2));
    CHECK(at("back_in", 0.5) == Approx(0.25 * (2.70158 / 2 - 1.70158)));
    CHECK(at("bounce_out", 4 / 11.0) == Approx(1));
    CHECK(at("bounce_out", 6 / 11.0) == Approx(0.75));
    CHECK(at("elastic_out", 0.075) == Approx(1).margin(1e-6));  // its first passing of the goal
}

TEST_CASE("a tween moves the fields of a table to its goals in time and calls its end once") {
    LuaBench bench;
    REQUIRE(bench.run(
                "t = { x = 10, y = 0 } ended = 0 tween = cairn.tween.to(t, { x = 20, y = -4 }, 0.5, { ease = "
                "'linear', done = function() ended = ended + 1 end })") == "");
    frame(bench, 15);
    CHECK(number(bench, "t.x") == Approx(15));
    CHECK(number(bench, "t.y") == Approx(-2));
    CHECK(bench.value("tween:is_active()") == "true");
    frame(bench, 14);
    CHECK(bench.value("ended") == "0");
    frame(bench);
    CHECK(bench.value("t.x .. ' ' .. t.y .. ' ' .. ended") == "20.0 -4.0 1");
    CHECK(bench.value("tween:is_active()") == "false");
    REQUIRE(bench.run("t.x = 3") == "");
    frame(bench, 100);
    CHECK(bench.value("t.x .. ' ' .. ended") == "3 1");
}

TEST_CASE("a delayed tween starts from what it finds when it begins") {
    LuaBench bench;
    REQUIRE(bench.run("t = { x = 0 } cairn.tween.to(t, { x = 10 }, 0.1, { delay = 0.5, ease = 'linear' })") ==
            "");
    frame(bench, 10);
    REQUIRE(bench.run("t.x = 4") == "");
    frame(bench, 20);
    CHECK(number(bench, "t.x") == 4);
    frame(bench, 3);
    CHECK(number(bench, "t.x") == Approx(7));
    frame(bench, 3);
    CHECK(number(bench, "t.x") == 10);
}

TEST_CASE("repeats start over, and with yoyo go back and forth") {
    LuaBench bench;
    REQUIRE(
        bench.run(
            "a, b, c = { x = 0 }, { x = 0 }, { x = 0 } cairn.tween.to(a, { x = 6 }, 0.1, { ease = 'linear', "
            "repeats = 1 }) cairn.tween.to(b, { x = 6 }, 0.1, { ease = 'linear', repeats = 1, yoyo = true }) "
            "cairn.tween.to(c, { x = 6 }, 0.1, { ease = 'linear', repeats = -1, yoyo = true })") == "");
    const double a[] = {1, 2, 3, 4, 5, 6, 1, 2, 3, 4, 5, 6, 6, 6};
    const double b[] = {1, 2, 3, 4, 5, 6, 5, 4, 3, 2, 1, 0, 0, 0};
    const double c[] = {1, 2, 3, 4, 5, 6, 5, 4, 3, 2, 1, 0, 1, 2};
    for (int i = 0; i < 14; ++i) {
        frame(bench);
        INFO(i);
        CHECK(number(bench, "a.x") == Approx(a[i]).margin(1e-9));
        CHECK(number(bench, "b.x") == Approx(b[i]).margin(1e-9));
        CHECK(number(bench, "c.x") == Approx(c[i]).margin(1e-9));
    }
}

TEST_CASE("a newer tween takes over the fields that it moves, and only those") {
    LuaBench bench;
    REQUIRE(bench.run(
                "t = { x = 0, y = 0 } old = cairn.tween.to(t, { x = 60, y = 60 }, 1, { ease = 'linear' })") ==
            "");
    frame(bench, 10);
    REQUIRE(bench.run("new = cairn.tween.to(t, { x = 0 }, 0.1, { ease = 'linear' })") == "");
    frame(bench, 6);
    CHECK(number(bench, "t.x") == 0);
    CHECK(number(bench, "t.y") == Approx(16));
    frame(bench, 10);
    CHECK(number(bench, "t.x") == 0);
    REQUIRE(bench.run("cairn.tween.to(t, { y = 1 }, 1)") == "");
    CHECK(bench.value("old:is_active()") == "false");
}

TEST_CASE("tweens are cancelled alone or by their table, and may be so from their own ends") {
    LuaBench bench;
    REQUIRE(
        bench.run("a, b = { x = 0, y = 0 }, { x = 0 } one = cairn.tween.to(a, { x = 60 }, 1) "
                  "cairn.tween.to(a, { y = 60 }, 1) cairn.tween.to(b, { x = 60 }, 1, { ease = 'linear' })") ==
        "");
    frame(bench, 5);
    REQUIRE(bench.run("one:cancel() one:cancel() x, y = a.x, a.y") == "");
    frame(bench);
    CHECK(bench.value("a.x == x and a.y > y") == "true");
    REQUIRE(bench.run("cairn.tween.cancel_all(a) y = a.y") == "");
    frame(bench);
    CHECK(bench.value("a.y == y") == "true");
    CHECK(number(bench, "b.x") == Approx(7));
    REQUIRE(bench.run("b.x = 0 count = 0 local function again() count = count + 1 cairn.tween.cancel_all(b) "
                      "cairn.tween.to(b, { x = count }, 0.05, { done = again }) end again()") == "");
    frame(bench, 30);
    CHECK(number(bench, "count") == 11);
}

TEST_CASE("a field that is no number any more is an error with the place of its tween, which is over then") {
    const std::vector<std::pair<std::string, std::string>> values = {
        {"nil", "nil"}, {"'far'", "\"far\""}, {"{}", "a table"}, {"true", "true"}};
    for (const auto& [value, shown] : values) {
        // Before it begins, at its beginning, and on its way.
        for (const int frames : {0, 5, 20}) {
            CAPTURE(value, frames);
            LuaBench bench;
            REQUIRE(bench.run(
                        "t, u = { x = 0, y = 0 }, { x = 0 }\n"
                        "tween = cairn.tween.to(t, { x = 60, y = 6 }, 1, { delay = 5 / 60, done = print })\n"
                        "cairn.tween.to(u, { x = 60 }, 1, { ease = 'linear' })") == "");
            frame(bench, frames);
            REQUIRE(bench.run("t.y = " + value) == "");
            std::optional<ScriptError> error;
            for (int i = 0; i < 10 && !error; ++i) error = bench.game().update({});
            REQUIRE(error);
            CHECK(error->message ==
                  "test.lua:2: cairn.tween.to: target.y is " + shown + " by now; expected a number");
            CHECK(bench.value("tween:is_active()") == "false");
            CHECK(bench.value("t.y == " + (value == "{}" ? "t.y" : value)) == "true");
            frame(bench, 100);  // the other one goes on
            CHECK(number(bench, "u.x") == 60);
        }
    }
}

TEST_CASE("wrong tweens say what is wrong") {
    LuaBench bench;
    REQUIRE(bench.run("t = { x = 1, name = 'n' }") == "");
    CHECK(bench.run("cairn.tween.to(t, { x = 2 }, -1)") ==
          "test.lua:1: cairn.tween.to: seconds is -1; expected a number, at least 0 s");
    CHECK(bench.run("cairn.tween.to(t, {}, 1)") ==
          "test.lua:1: cairn.tween.to: goals is empty; expected fields with numbers");
    CHECK(bench.run("cairn.tween.to(t, { name = 2 }, 1)") ==
          "test.lua:1: cairn.tween.to: target.name is \"n\"; expected a number");
    CHECK(bench.run("cairn.tween.to(t, { x = 0/0 }, 1)") ==
          "test.lua:1: cairn.tween.to: goals.x is nan; expected a finite number");
    const std::string all =
        " (linear, or quad, cubic, quart, quint, sine, expo, circ, back, elastic, bounce with _in, _out or "
        "_in_out)";
    CHECK(bench.run("cairn.tween.to(t, { x = 2 }, 1, { ease = 'qad_out' })") ==
          "test.lua:1: cairn.tween.to: ease = \"qad_out\": no such ease; did you mean \"quad_out\"?" + all);
    CHECK(bench.run("cairn.tween.ease('wibble', 0.5)") ==
          "test.lua:1: cairn.tween.ease: name is \"wibble\": no such ease" + all);
    CHECK(bench.run("cairn.tween.to(t, { x = 2 }, 1, { repeats = -2 })").find("at least -1") !=
          std::string::npos);
    CHECK(bench.run("cairn.tween.to(t, { x = 2 }, 1, { done = 3 })").find("must be a function") !=
          std::string::npos);
    CHECK(bench.run("for i = 1, 20000 do cairn.tween.to({ x = 1 }, { x = 2 }, 1) end")
              .find("10000 tweens are running already") != std::string::npos);
}

}  // namespace cairn::scripting::test
