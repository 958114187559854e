using System.Xml.Linq;

namespace FootballPhysics.Site.Pictures;

/// <summary>The pictures of docs/, each drawn from what the library answers.</summary>
internal static class DocPictures
{
    /// <summary>Width of a picture: on a phone it is shown nearly at its size.</summary>
    public const double Width = 480;

    /// <summary>Where they are kept, from the folder of the repository.</summary>
    public const string Folder = "docs/pictures";

    /// <summary>Their names, and how each is drawn.</summary>
    public static IReadOnlyList<(string Name, Func<XElement> Draw)> All { get; } =
    [
        ("frame", FramePicture.Draw),
        ("spin", FlightPictures.Spin),
        ("air", FlightPictures.Air),
        ("knuckle", BallPictures.Knuckle),
        ("presets", BallPictures.Presets),
        ("bounce", FlightPictures.Bounce),
        ("reach", PlayPictures.Reach),
        ("fan", PlayPictures.Fan),
        ("misses", PlayPictures.Misses),
        ("heights", GroundPictures.Heights),
        ("first-kick", KickPictures.FirstKick),
        ("wall", KickPictures.Wall),
        ("ahead", KickPictures.Ahead),
        ("header", KickPictures.Header),
        ("arcs", KickPictures.Arcs),
        ("waypoint", KickPictures.Waypoint),
        ("drop", KickPictures.Drop),
        ("two-shots", KickPictures.TwoShots),
        ("leg", KickPictures.Leg),
        ("late-kick", GamePictures.LateKick),
        ("correction", GamePictures.Correction),
        ("unity-kick", GamePictures.UnityKick),
        ("unity-air", GamePictures.UnityAir),
        ("godot-kick", GamePictures.GodotKick),
        ("godot-air", GamePictures.GodotAir),
        ("pixels", DataPictures.Pixels),
        ("pieces", DataPictures.Pieces),
        ("work", DataPictures.Work),
        ("batch", DataPictures.Batch),
        ("live", FollowingPictures.Live),
        ("follow", FollowingPictures.AfterKicks),
    ];
}
