using BenchmarkDotNet.Attributes;

namespace Football.Physics.Benchmarks;

public class SphereBenchmarks
{
    private double _radius = 0.11;

    [Benchmark]
    public double CrossSection() => Sphere.CrossSection(_radius);

    [GlobalSetup]
    public void Setup() => _radius = 0.11;
}
