namespace Football.Physics;

/// <summary>A method of finding a kick. A new one is one new file, and a name in <see cref="AimMethod"/>.</summary>
internal interface IAimMethod
{
    /// <summary>Finds a kick; the request has been checked.</summary>
    AimSolution Find(AimRequest request);
}
