namespace FootballPhysics.Package.Tests;

/// <summary>docs/api.md is made from the assemblies and their XML documentation, and is kept current.</summary>
public sealed class ApiReferenceTests
{
    [Fact]
    public void The_API_reference_is_current() => Repository.AssertCurrent("docs/api.md", ApiReference.Make([.. ((Type[])[typeof(Ball), typeof(BallBatch), typeof(NetBulges), typeof(ThesisAimer), typeof(TrackFit)]).Select(type => type.Assembly)]));
}
