using System.Globalization;
using FootballPhysics;
using FootballPhysics.Friction;

// Exit code 0 if all slides agree with the law μ(v) = μ₀ (1 + a e^(−v/b)), else 1.
//   Friction A B
double a = double.Parse(args[0], CultureInfo.InvariantCulture);
double b = double.Parse(args[1], CultureInfo.InvariantCulture);
var law = new SlipLaw(a, b);

Console.WriteLine("| slide | method | Hz | slip, off m/s | way, off m | end of the slide, off s | speed of the roll, off m/s | |");
Console.WriteLine("|---|---|--:|--:|--:|--:|--:|---|");
bool all = true;
foreach (Track track in Track.All)
{
    foreach (Integrator method in new[] { Integrator.Rk2, Integrator.Rk4 })
    {
        foreach (int rate in new[] { 60, 240 })
        {
            Errors errors = Slide.Compare(track, law, method, rate);
            double most = method == Integrator.Rk4 ? 1e-6 : 3e-4;

            // Where both contacts of a set stop slipping at once, impulses take the rest of the step, and the roll is reported at its end.
            bool agrees = errors.Within(most, track.Lean > 0 ? 1.0 / rate : most);
            all &= agrees;
            Console.WriteLine(string.Create(
                CultureInfo.InvariantCulture,
                $"| {track.Name} | {method} | {rate} | {errors.Slip:0.0e0} | {errors.Way:0.0e0} | {errors.End:0.0e0} | {errors.Roll:0.0e0} | {(agrees ? "ok" : "**off**")} |"));
        }
    }
}

return all ? 0 : 1;
