using System.Globalization;
using FootballPhysics.Live;

// Without arguments: serves the page on port 5077 until it is interrupted. "port N": on another port. "compare SECONDS": prints the errors of both filters instead.
switch (args)
{
    case []:
        return await Serve(5077);
    case ["port", string text] when int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int port) && port <= 65535:
        return await Serve(port);
    case ["compare", string text] when double.TryParse(text, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out double seconds) && seconds is >= 1 and <= 36000:
        return Compare(seconds);
    default:
        Console.Error.WriteLine("Usage: football-live [port 0–65535 | compare 1–36000]");
        return 2;
}

static async Task<int> Serve(int port)
{
    await using LiveServer server = await LiveServer.Start(port);
    Console.WriteLine(server.Address);
    await server.Wait();
    return 0;
}

static int Compare(double seconds)
{
    var feed = new Feed(1);
    var follower = new Follower();
    int trueKicks = 0;
    double last = double.NegativeInfinity;
    Picture picture;
    Frame frame;
    do
    {
        picture = feed.Next();
        frame = follower.Follow(picture);
        trueKicks += picture.Kicked > last ? 1 : 0;
        last = picture.Kicked;
    }
    while (picture.Time < seconds);

    Console.WriteLine(FormattableString.Invariant($"kicks: {trueKicks}, found: {frame.Kicks}"));
    Console.WriteLine(FormattableString.Invariant($"error of the position {Follower.Judged} s ahead, root mean square of {follower.Compared} predictions:"));
    Console.WriteLine(FormattableString.Invariant($"  BallFilter         {frame.Error:F2} m"));
    Console.WriteLine(FormattableString.Invariant($"  constant velocity  {frame.LineError:F2} m"));
    return 0;
}
