using System.Globalization;

namespace FootballPhysics.Web.Tests;

/// <summary>The forces and the dials of the page to play with, against the library in C#.</summary>
public sealed class PlayForcesTests(Browser browser, ITestOutputHelper told)
{
    private const double TimeStep = 0.01;

    [Fact]
    public async Task The_arrows_are_the_forces_of_the_library_and_the_overlay_has_the_numbers_of_the_ball()
    {
        Window window = await browser.Playing("#keeper=0&wall=0&speed=20&elevation=20&azimuth=20&side=40&top=10&distance=45&aside=20");
        Assert.True(await window.Page.Locator("#forces-shown").IsHiddenAsync());
        await window.Page.ClickAsync("#forces");
        await window.Page.ClickAsync("#kick");
        // Both are read in one call, because the ball goes on flying between two calls.
        await window.Until("playground.time > 0.3 && document.body.dataset.arrows && (window.seen = [document.body.dataset.arrows, document.getElementById('forces-shown').innerText])");
        Assert.Contains("\"weight\",\"buoyancy\",\"drag\",\"magnus\"", await window.Page.EvaluateAsync<string>("() => window.seen[0]"));
        string text = await window.Page.EvaluateAsync<string>("() => window.seen[1]");
        Assert.Matches(@"^\d+\.\d m/s · \d+ rad/s\s+Re \d\.\d\de5 · it flies\s+weight 4\.\d\d N", text);
        await window.Picture("forces");
        await window.Flown();
        double[] rows = await window.Numbers(
            "playground.flights[0].forces.flatMap(f => [f.t, f.of ? 1 : 0, ...['weight', 'buoyancy', 'drag', 'magnus', 'load', 'friction'].flatMap(name => f.of ? f.of[name] : [0, 0, 0])])");

        var simulator = new Simulator(Scene(new Vector3d(-20, 0, -45)));
        var ball = new Ball(simulator);
        ball.Kick(speed: 20, elevationDegrees: 20, azimuthDegrees: 20, topSpin: 10, sideSpin: 40);
        int onGround = 0;
        foreach (double[] row in rows.Chunk(20))
        {
            BallForces? f = ball.GetForces(TimeStep);
            double[] expected = f is null
                ? [ball.Time, 0, .. new double[18]]
                : [ball.Time, 1, .. Parts(f.Weight), .. Parts(f.Buoyancy), .. Parts(f.Drag), .. Parts(f.Magnus), .. Parts(f.Load), .. Parts(f.Friction)];
            Assert.Equal(expected, row);
            onGround += f?.Contacts.Count > 0 ? 1 : 0;
            ball.Step(TimeStep);
        }

        Assert.True(onGround > 50, "The ball also rolls.");
        told.WriteLine($"{rows.Length / 20} times six forces with the bits of C#, {onGround} of them on the ground");
        await window.Page.ClickAsync("#forces");
        // The page hides the overlay with the next frame that it draws.
        await window.Until("document.getElementById('forces-shown').hidden");
        Assert.Empty(window.Errors);
    }

    [Fact]
    public async Task A_dial_acts_on_the_ball_that_moves()
    {
        Window window = await browser.Playing("#keeper=0&wall=0&speed=12&elevation=0&azimuth=20&side=0&top=0&distance=45&aside=20");
        await window.Page.ClickAsync("#kick");
        await window.Until("playground.time > 0.4");
        await window.Page.EvaluateAsync(
            "() => { window.before = playground.flights; const dial = document.querySelector('[name=wetness]'); dial.value = 1; dial.dispatchEvent(new Event('input', { bubbles: true })); }");
        await window.Until("playground.flights !== window.before && playground.flights.every(f => f.isOver)");
        double changed = double.Parse((await window.Said("turned"))!, CultureInfo.InvariantCulture);
        Assert.InRange(changed, 0.4, 3);
        Assert.True(await window.Page.EvaluateAsync<bool>("() => playground.flights.length === 1 && playground.time > 0.4"), "The ball is not put back on its spot.");
        double[] keys = await window.Numbers("playground.flights[0].keys.flatMap(k => [k.t, ...k.p, ...k.v])");
        Dictionary<double, double[]> seen = keys.Chunk(7).ToDictionary(row => row[0]);

        Scene dry = Scene(new Vector3d(-20, 0, -45));
        var simulator = new Simulator(dry);
        var ball = new Ball(simulator);
        ball.Kick(speed: 12, elevationDegrees: 0, azimuthDegrees: 20, topSpin: 0, sideSpin: 0);
        BallState state = ball.State, stays = ball.State;
        var log = new StepLog();
        var wet = new Simulator(new Dials { Wetness = 1 }.Apply(dry));
        Simulator now = simulator;
        while (state.Time < keys[^7])
        {
            if (now == simulator && changed <= state.Time)
            {
                state = new Ball(wet) { State = state }.State;
                now = wet;
            }

            log.Clear();
            now.Step(ref state, TimeStep, log);
            log.Clear();
            simulator.Step(ref stays, TimeStep, log);
            Assert.Equal([state.Time, .. Parts(state.Position), .. Parts(state.Velocity)], seen[state.Time]);
        }

        double apart = (state.Position - stays.Position).Length;
        Assert.True(apart > 0.1, "The dial changes the course.");
        told.WriteLine(FormattableString.Invariant($"wet from {changed:F2} s on: the bits of C# to {state.Time:F2} s, {apart:F2} m from the dry ball"));
        Assert.Empty(window.Errors);
    }

    private static Scene Scene(Vector3d goal) => FootballPhysics.Scene.Default with
    {
        Ball = BallProperties.Presets["modern"],
        Ground = Ground.Presets["matchTurf"],
        Goals = [new Goal { Center = goal, Facing = new Vector3d(0, 0, 1) }],
    };

    private static double[] Parts(Vector3d v) => [v.X, v.Y, v.Z];
}
