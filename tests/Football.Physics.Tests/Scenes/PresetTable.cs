using System.Globalization;
using System.Text;

namespace FootballPhysics.Tests.Scenes;

/// <summary>Every number of the measured profile's presets as the code has it, with what it rests on.</summary>
internal static class PresetTable
{
    private const string Rigs = "FIFA's rigs";
    private const string Ratio = "the default × a ratio of Hong and Asai 2014";
    private const string Tunnel = "Kiratidis and Leinweber, arXiv:1710.02784";

    /// <summary>The table in Markdown.</summary>
    public static string Markdown()
    {
        var text = new StringBuilder("\n| preset | number | value | | source or range |\n|---|---|--:|---|---|\n");
        foreach ((string preset, string number, double value, string tag, string source) in Rows())
        {
            text.Append(CultureInfo.InvariantCulture, $"| {preset} | {number} | {Text(value)} | {tag} | {source} |\n");
        }

        return text.Append('\n').ToString();
    }

    public static IEnumerable<(string Preset, string Number, double Value, string Tag, string Source)> Rows() =>
        Ball().Concat(Curves()).Concat(Laws()).Concat(Surfaces()).Concat(Weathers());

    private static IEnumerable<(string, string, double, string, string)> Ball()
    {
        BallProperties ball = BallProperties.Tunnel;
        yield return ("ball", "mass, kg", ball.Mass, "law", "IFAB, Law 2: 0.41 … 0.45");
        yield return ("ball", "radius, m", ball.Radius, "law", "IFAB, Law 2: 68 … 70 cm around");
        yield return ("ball", "α", ball.InertiaFactor, "derived", "a thin shell; layered balls ±0.03, guess");
        yield return ("ball", "K, N", ball.KnuckleForce, "measured", "German Sport University Cologne: five types kicked by a robot at 29 m/s over 22 m; types 0.9 … 2.2");
        yield return ("Tango 12", "K, N", BallProperties.Tango12.KnuckleForce, "derived", Ratio);
        yield return ("Teamgeist", "K, N", BallProperties.Teamgeist.KnuckleForce, "derived", Ratio);
        yield return ("Jabulani", "K, N", BallProperties.Jabulani.KnuckleForce, "derived", Ratio);
        yield return ("beach ball", "Λ", BallProperties.BeachBall.ReverseLift, "guess", "0 … 0.4; 0 for match balls, whose measured lift is positive");
    }

    private static IEnumerable<(string, string, double, string, string)> Curves()
    {
        (string Name, DragCurve Curve, string Tag, string Source)[] curves =
        [
            ("ball", DragCurve.Generic, "derived", "mean of Tango 12, Teamgeist and Brazuca, rounded"), ("Tango 12", DragCurve.Tango12, "measured", Tunnel),
            ("Teamgeist", DragCurve.Teamgeist, "measured", Tunnel), ("Jabulani", DragCurve.Jabulani, "measured", Tunnel), ("Brazuca", DragCurve.Brazuca, "measured", Tunnel),
            ("modern", DragCurve.Modern, "measured", "roughness 0.86: the flights of one minute of one match at 2 600 m, 2024; crisis 85 000 … 110 000"),
            ("Telstar 18", BallProperties.Telstar18.DragCurve, "derived", "critical Re 2.7 against 2.3e5 of Brazuca (Asai and Hong 2021); range 8 … 10 % below Brazuca (Goff, Hong and Asai 2018, press)"),
            ("Flight 2020", BallProperties.Flight2020.DragCurve, "guess", "measured is only: earlier crisis and slightly more drag than a 32-panel ball (Asai and Hong 2021)"),
            ("Al Rihla", BallProperties.AlRihla.DragCurve, "derived", "roughness 0.31: crisis later than Trionda's, near Brazuca's, as reported"),
            ("Fussballliebe", BallProperties.Fussballliebe.DragCurve, "guess", "measured is only: shortest of ten balls, earlier crisis (KJSS 35(2):392, 2024)"),
            ("Trionda", BallProperties.Trionda.DragCurve, "guess", "crisis measured (12.1 m/s, University of Tsukuba, as reported); b₀ and b₁ guess: more drag at speed, a few metres short (press)"),
            ("beach ball", BallProperties.BeachBall.DragCurve, "derived", "a smooth sphere (Achenbach 1972)"),
        ];
        foreach ((string name, DragCurve curve, string tag, string source) in curves)
        {
            yield return (name, "a", curve.Subcritical, tag, source);
            yield return (name, "Re_c", curve.CriticalReynolds, tag, source);
            yield return (name, "Re_s", curve.Width, tag, source);
            yield return (name, "b₀", curve.Supercritical, tag, source);
            yield return (name, "b₁", curve.Risen, tag, source);
            yield return (name, "Re₀", curve.RiseFrom, tag, source);
            yield return (name, "Re₁", curve.RiseTo, tag, source);
        }
    }

    private static IEnumerable<(string, string, double, string, string)> Laws()
    {
        yield return ("lift", "L", SaturatingLift.Limit, "measured", "fit to 13 points: Asai 2007; Goff and Carré 2009; Kiratidis and Leinweber");
        yield return ("lift", "S₀", SaturatingLift.Scale, "measured", "the same fit");
        yield return ("lift", "η₀", SaturatingLift.Subcritical, "guess", "0 … 1");
        yield return ("drag by spin", "D", SpinDrag.Limit, "measured", "between Goff and Carré 2009 and Kiratidis and Leinweber");
        yield return ("drag by spin", "S_D", SpinDrag.Scale, "measured", "likewise");
        yield return ("drag by spin", "κ₀", SpinDrag.Subcritical, "guess", "0 … 1");
        yield return ("spin decay", "β", ProportionalSpinDecay.Beta, "guess", "measured on golf balls, Smits and Smith 1994; 0.003 … 0.012");
        yield return ("spin decay", "ε, 1/s", ProportionalSpinDecay.AtRest, "guess", "0.003 … 0.006");
        yield return ("knuckle force", "Strouhal number", KnuckleForce.Strouhal, "measured", "Hong and Asai 2014: peak at 2.5 Hz at 30 m/s");
        yield return ("knuckle force", "power of the wake", KnuckleForce.Growth, "measured", "Hong and Asai 2014: 320 % from 20 to 30 m/s, 2.9 − 2");
        yield return ("knuckle force", "c_W", KnuckleForce.Wake, "guess", "0 … 0.7");
        yield return ("knuckle force", "w", SeamField.FineShare, "guess", "0 … 1");
        yield return ("knuckle force", "g₀", KnuckleForce.Subcritical, "guess", "0 … 1");
        yield return ("knuckle force", "S_K", KnuckleForce.SpinScale, "guess", "0.05 … ∞; matters only if the axis is tilted towards the motion");
        var foot = new Foot();
        yield return ("foot", "mass, kg", foot.Mass, "guess", "1.5 … 3");
        yield return ("foot", "e", foot.Restitution, "guess", "0.5 … 0.6");
        yield return ("foot", "e_t", foot.TangentialRestitution, "guess", "the ball leaves without slip");
        yield return ("foot", "μ", foot.Friction, "guess", "leather 0.37 … 0.63 measured, and 0.5 for the dent");
    }

    private static IEnumerable<(string, string, double, string, string)> Surfaces()
    {
        (string Name, SurfaceMaterial Material, Dictionary<string, (string Tag, string Source)> Known)[] materials =
        [
            ("dry turf", SurfaceMaterial.DryTurf, OfTurf("drop 0.60 … 1.00 m, angle 45 … 60 %, roll 4 … 10 m")),
            ("artificial turf", SurfaceMaterial.ArtificialTurf, OfTurf("FIFA Quality Pro: drop 0.60 … 0.85 m, angle 45 … 60 %, roll 4 … 8 m")),
            ("watered turf", SurfaceMaterial.WetTurf, new() { ["e₆"] = ("measured", Rigs + ": drop 0.60 … 1.00 m") }),
            ("match turf", SurfaceMaterial.MatchTurf, new()
            {
                ["e₆"] = ("measured", "24 impacts of one match and 20 of another: 0.62 … 0.74; FIFA's rigs: drop 0.60 … 1.00 m"),
                ["η"] = ("measured", "the same impacts: 0 … 0.7, the first match 0.70, the second 0 … 0.25"),
                ["e_t"] = ("measured", "the same impacts, slow ones that grip: −0.3 … −0.1"),
                ["μ_i"] = ("measured", "the same impacts: 0.28 … 0.42; the angle of a wet pitch, 45 … 80 %, needs 0.415"),
                ["μ_s"] = ("measured", "slides of two matches: 0.41 … 0.46 by hand, 0.48 ± 0.02 and 0.49 ± 0.06 by fit --match"),
                ["c₀"] = ("measured", "twelve rolls of one match: c₀ + c₁ v 0.05 … 0.11, median 0.076; two others 0.064 and 0.060 at 3 m/s"),
                ["c₁, s/m"] = ("guess", "the same rolls: 0 … 0.007"),
            }),
            ("hard ground", SurfaceMaterial.HardGround, new()),
            ("long grass", SurfaceMaterial.LongGrass, new()),
            ("indoor", SurfaceMaterial.Indoor, new()),
            ("concrete", SurfaceMaterial.Concrete, new() { ["e₆"] = ("measured", "a test ball bounces to 1.35 ± 0.03 m from 2 m") }),
            ("snow", SurfaceMaterial.Snow, new()),
        ];
        foreach ((string name, SurfaceMaterial material, Dictionary<string, (string Tag, string Source)> known) in materials)
        {
            foreach ((string number, double value) in NumbersOf(material))
            {
                (string tag, string source) = known.GetValueOrDefault(number, ("guess", ""));
                yield return (name, number, value, tag, source);
            }
        }

        yield return ("match turf", "V_e, m/s", SurfaceMaterial.MatchTurf.RestitutionSpeedScale, "derived", "best fit of both matches 15 … 30");
        yield return ("other surfaces", "V_e, m/s", SurfaceMaterial.DryTurf.RestitutionSpeedScale, "guess", "20 … ∞");
        yield return ("all surfaces", "least bounce, m/s", new Ground().MinimumBounceSpeed, "guess", "a hop of 2 mm");
        yield return ("all surfaces", "rest energy, J", new Ground().RestEnergy, "guess", "");
        SurfaceMaterial frame = SurfaceMaterial.GoalFrame;
        yield return ("goal frame", "e₆", frame.NormalRestitution, "guess", "others' priors 0.65 … 0.80");
        yield return ("goal frame", "V_e, m/s", frame.RestitutionSpeedScale, "guess", "");
        yield return ("goal frame", "e_t", frame.TangentialRestitution, "guess", "");
        yield return ("goal frame", "μ_i", frame.ImpactFriction, "guess", "");
    }

    private static IEnumerable<(string, string, double, string, string)> Weathers()
    {
        var weather = new Weather();
        var wind = new WindByHeight(1, 1, 0);
        var gusts = new Gusts();
        yield return ("weather", "temperature, °C", weather.Temperature, "guess", "a mild day");
        yield return ("weather", "humidity", weather.Humidity, "guess", "likewise");
        yield return ("weather", "pressure, Pa", weather.Pressure, "law", "standard atmosphere");
        yield return ("wind by height", "reference height, m", wind.ReferenceHeight, "law", "where meteorology measures wind");
        yield return ("wind by height", "roughness, m", wind.Roughness, "measured", "short grass");
        yield return ("gusts", "intensity", gusts.Intensity, "guess", "open grassland at 10 m");
        yield return ("gusts", "length, m", gusts.Length, "guess", "");
    }

    private static Dictionary<string, (string Tag, string Source)> OfTurf(string windows) => new()
    {
        ["e₆"] = ("measured", $"{Rigs}: {windows}"),
        ["e_t"] = ("measured", "the same windows"),
        ["μ_i"] = ("guess", "at least 0.91 derived from the angle"),
        ["c₀"] = ("measured", "the same windows, given c₁"),
    };

    private static IEnumerable<(string Number, double Value)> NumbersOf(SurfaceMaterial material) =>
    [
        ("e₆", material.NormalRestitution), ("η", material.GrazingRestitutionGain), ("e_t", material.TangentialRestitution), ("μ_i", material.ImpactFriction), ("μ_s", material.SlidingFriction),
        ("c₀", material.RollingResistance), ("c₁, s/m", material.RollingResistancePerSpeed), ("b, m", material.TorsionalPatchRadius),
    ];

    private static string Text(double value) =>
        value >= 1000 ? value.ToString("0", CultureInfo.InvariantCulture) : value.ToString("0.####", CultureInfo.InvariantCulture);
}
