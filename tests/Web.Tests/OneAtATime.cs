// Programs are built and browsers run in folders that two tests at once would share.
[assembly: Xunit.v3.Parallelization(Mode = Xunit.Sdk.ParallelMode.None)]
[assembly: AssemblyFixture(typeof(FootballPhysics.Web.Tests.Browser))]
