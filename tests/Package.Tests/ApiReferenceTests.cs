namespace Football.Physics.Package.Tests;

/// <summary>docs/api.md is made from the assembly and its XML documentation, and is kept current.</summary>
public sealed class ApiReferenceTests
{
    [Fact]
    public void The_API_reference_is_current() => Repository.AssertCurrent("docs/api.md", ApiReference.Make(typeof(Ball).Assembly));
}
