namespace Football.Physics;

/// <summary>Is shown the type of a scene's air.</summary>
internal interface IAirVisitor<TResult>
{
    /// <summary>Makes something of the air.</summary>
    TResult Visit<TAir>(Scene scene)
        where TAir : struct, ILawsAir;
}
